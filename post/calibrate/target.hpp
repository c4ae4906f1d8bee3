// Targets of a calibration: laboratory properties of a rock that the assemblage is to reproduce.
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "post/measure/property.hpp"
#include "post/statistics/statistics.hpp"
#include "share/base/toml_file.hpp"
#include "share/rock/material.hpp"

namespace graincrack::calibrate {

/// Numbers of a run in the tables `strength`, `moduli` and `toughness`, by column, without those that do not apply.
using Measures = std::map<std::string, double>;

enum class Use { fit, predict };

struct Target {
    Property property;
    double confining_pressure = 0;  ///< Pa
    double value = 0;               ///< SI; NaN of a prediction without a measured value
    double deviation = 0;           ///< standard deviation of the measured value, SI; also the bound of the confirmation
    Use use = Use::fit;
    std::optional<ToughnessTest> measured_on = {};  ///< the laboratory's test for K_IC, if the material has it
    bool is_on_line = false;  ///< true if its value is from the line UCS + b σ3 of the friction angle, not from a test

    [[nodiscard]] std::string name() const;         ///< "first_peak_8MPa"
    [[nodiscard]] std::string fitted_name() const;  ///< its name in [fitted]: "confined_strength_8MPa"
    [[nodiscard]] std::string symbol() const;       ///< "first peak at 8 MPa"
    [[nodiscard]] std::string test() const;         ///< name of the test that measures it
    /// True if the elastic constants of the grains are scaled to meet it.
    [[nodiscard]] bool is_elastic() const { return property.name == "young_modulus" || property.name == "poisson_ratio"; }
    /// Its value in a run, SI; NaN if the tables have none.
    [[nodiscard]] double read(const Measures& measures) const;
    /// Says why a value of K_IC on this specimen has no verdict, as `ToughnessTest::caveat` does; "" if it may have one.
    [[nodiscard]] std::string caveat(const ToughnessTest& tested) const;
    [[nodiscard]] double usual_deviation() const;  ///< usual deviation of its value, SI, by its property
    /// The quantity of response surfaces: ln of a value or, for a fall, ln of 1 less the fall, which may exceed 1 where the
    /// stress rises. NaN if there is no logarithm.
    [[nodiscard]] double logarithm(double value_in_si) const;
    [[nodiscard]] double of_logarithm(double logarithm) const;  ///< the inverse of `logarithm`
    /// The deviation of `logarithm` that a small deviation of the value causes.
    [[nodiscard]] double log_deviation(double value_in_si, double off) const { return off / std::abs(base(value_in_si)); }
    [[nodiscard]] double log_deviation() const { return log_deviation(value, deviation); }
    [[nodiscard]] std::string text(double value_in_si) const;  ///< with the unit: "8.8 MPa"

private:
    [[nodiscard]] bool is_fall() const { return property.name == "drop"; }
    [[nodiscard]] double base(double value_in_si) const { return is_fall() ? 1 - value_in_si : value_in_si; }
};

/// The agreement of a computed mean with the measured value of a target.
enum class Agreement {
    unknown,    ///< there is no value to compare, or the measured value has no deviation
    within,     ///< the whole 95 % interval of the mean lies within the deviation
    outside,    ///< the whole interval lies beyond the deviation
    undecided,  ///< the interval crosses a bound, or there is none
};
/// "", "within", "outside" or "undecided".
std::string name_of(Agreement agreement);
Agreement agreement_of(const Target& target, const Estimate& computed);

/// Returns the target of this name, without a value. \throws InputError that begins with `where` if there is none
Target target_of(const std::string& name, const std::string& where);

/// Adds the laboratory's test of the material to a target of K_IC.
void set_toughness_test(Target& target, const Material& material);

/// Reads the rows of [targets]; empty without this table. \throws InputError that names file and key of what is wrong
std::vector<Target> given_targets(const TomlFile& file);

/// Gives a target its value in [laboratory], NaN if there is none. A confined strength without a value at its pressure has
/// UCS + b σ3.
void take_laboratory_entry(const Material& material, Target& target);
/// The note beside a value that is on the line.
inline constexpr const char* no_test = "φ line, no test";

/// Reads the rows of [targets]. Without this table the targets are the laboratory's values: E, ν, Brazilian and uniaxial
/// strength, and the first peak at a confining pressure (Pa) on the line σ1 = UCS + b σ3, with b from the friction angle, or from
/// cohesion and UCS. Predictions are then the first peak at further pressures, direct tension, crack thresholds and, if measured,
/// K_IC. \throws InputError that names file and key of what is wrong or missing
std::vector<Target> targets_of(const Material& rock, const TomlFile& file, double confining_pressure,
                               const std::vector<double>& predicted_pressures);

/// Says that the UCS of the line of C and φ, 2 C √b, differs from the measured UCS by more than 3 %; "" if it does not.
std::string disagreement_text(const Material& rock);

/// The pressure for messages and names, as in "8MPa"; "" for none.
std::string pressure_text(double pascal);

}  // namespace graincrack::calibrate
