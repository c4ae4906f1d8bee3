// Targets of a calibration: properties that a rock has in the laboratory and the assemblage shall have too.
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

/// Numbers of a run in the tables `strength`, `moduli` and `toughness`, by column; a number that does not apply is not there.
using Measures = std::map<std::string, double>;

enum class Use { fit, predict };

struct Target {
    Property property;
    double confining_pressure = 0;  ///< Pa
    double value = 0;               ///< SI; NaN of a prediction without a measured value
    double deviation = 0;           ///< of the measured value, SI; also how far the confirmation may be off
    Use use = Use::fit;
    std::optional<ToughnessTest> measured_on = {};  ///< of K_IC: what the laboratory measured it on, as far as the material says
    bool is_on_line = false;  ///< its value is none of a test, but on the line UCS + b σ3 of the friction angle

    [[nodiscard]] std::string name() const;         ///< "first_peak_8MPa"
    [[nodiscard]] std::string fitted_name() const;  ///< of the same in [fitted]: "confined_strength_8MPa"
    [[nodiscard]] std::string symbol() const;       ///< "first peak at 8 MPa"
    [[nodiscard]] std::string test() const;         ///< name of the test that measures it
    /// Met by scaling the grains.
    [[nodiscard]] bool is_elastic() const { return property.name == "young_modulus" || property.name == "poisson_ratio"; }
    /// Its value in a run, SI; NaN if the tables have none.
    [[nodiscard]] double read(const Measures& measures) const;
    /// Why a value of K_IC on this specimen has no verdict, as `ToughnessTest::caveat`; "" if it may have one.
    [[nodiscard]] std::string caveat(const ToughnessTest& tested) const;
    [[nodiscard]] double usual_deviation() const;  ///< of its value, by its property
    /// What surfaces are of: ln of a value, for a fall of what is left behind it, as a test may also rise; NaN: it has none.
    [[nodiscard]] double logarithm(double value_in_si) const;
    [[nodiscard]] double of_logarithm(double logarithm) const;  ///< the inverse
    /// A deviation from a value in its logarithm.
    [[nodiscard]] double log_deviation(double value_in_si, double off) const { return off / std::abs(base(value_in_si)); }
    [[nodiscard]] double log_deviation() const { return log_deviation(value, deviation); }
    [[nodiscard]] std::string text(double value_in_si) const;  ///< with the unit: "8.8 MPa"

private:
    [[nodiscard]] bool is_fall() const { return property.name == "drop"; }
    [[nodiscard]] double base(double value_in_si) const { return is_fall() ? 1 - value_in_si : value_in_si; }
};

/// The agreement of a computed mean with the measured value of a target.
enum class Agreement {
    unknown,    ///< nothing to compare, or no deviation of the measured value
    within,     ///< the whole 95 % interval of the mean is within the deviation
    outside,    ///< it is beyond the deviation
    undecided,  ///< neither, or there is no interval
};
/// "", "within", "outside", "undecided"
std::string name_of(Agreement agreement);
Agreement agreement_of(const Target& target, const Estimate& computed);

/// A target of the name, without a value. \throws InputError naming `where` if there is none
Target target_of(const std::string& name, const std::string& where);

/// Adds to a target of K_IC what the laboratory of the material measured it on.
void set_toughness_test(Target& target, const Material& material);

/// The rows of [targets]; none without that table. \throws InputError naming file and key of what is wrong
std::vector<Target> given_targets(const TomlFile& file);

/// Gives a target its value in [laboratory]: NaN if there is none; of a confined strength the one measured at that pressure, else
/// UCS + b σ3.
void take_laboratory_entry(const Material& material, Target& target);
/// Said beside a value that is on the line.
inline constexpr const char* no_test = "φ line, no test";

/// The rows of [targets]; without that table the laboratory's values: E, ν, Brazilian and uniaxial strength, and the first peak
/// at a confining pressure on the line σ1 = UCS + b σ3, with b of the friction angle, or of cohesion and UCS; predicted are the
/// first peak at further pressures, direct tension, crack thresholds and, if it was measured, K_IC. \throws InputError naming
/// file and key of what is wrong or missing
std::vector<Target> targets_of(const Material& rock, const TomlFile& file, double confining_pressure,
                               const std::vector<double>& predicted_pressures);

/// "" unless the UCS of the line of C and φ, 2 C √b, is off the measured one by more than 3 %, in words.
std::string disagreement_text(const Material& rock);

/// "" or, for messages and names, the pressure as "8MPa".
std::string pressure_text(double pascal);

}  // namespace graincrack::calibrate
