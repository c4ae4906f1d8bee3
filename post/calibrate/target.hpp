// Targets of a calibration: what a rock has in the laboratory and the assemblage shall have too. What can be a target is one
// table.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "share/base/toml_file.hpp"
#include "share/rock/material.hpp"

namespace graincrack::calibrate {

/// What the tables `strength`, `moduli` and `toughness` say of a run, by column; what does not apply is not there.
using Measures = std::map<std::string, double>;

/// Where a kind of target takes its confining pressure from: the end of its name, "first_peak_8MPa".
enum class PressureOf { none, name, either };

/// A row of the table: what can be a target, which test has it and how it is read from it.
struct TargetKind {
    std::string name;    ///< of [targets], without a pressure
    std::string symbol;  ///< in reports
    std::string test;    ///< brazilian, tension, bend, compression
    PressureOf pressure = PressureOf::none;
    Quantity quantity;
    std::string unit;  ///< of reports
    double si = 1;     ///< that unit in SI
    /// Usual deviation of a measured value: a part of it, or the amount if `absolute`.
    double deviation = 0.05;
    bool absolute = false;
    /// Fall below the peak, a part of it, to which the test must go on; 1: to the strain limit.
    double peak_drop = 1;
    bool needs_first_peak = false;
    /// SI; NaN if the test has none.
    double (*read)(const Measures& measures) = nullptr;
    std::string fitted_key = {};  ///< in [fitted], where it is another than the name
};
const std::vector<TargetKind>& target_kinds();

enum class Use { fit, predict };

struct Target {
    TargetKind kind;
    double confining_pressure = 0;  ///< Pa
    double value = 0;               ///< SI; NaN of a prediction without a measured value
    double deviation = 0;           ///< of the measured value, SI; also how far the confirmation may be off
    Use use = Use::fit;

    [[nodiscard]] std::string name() const;         ///< "first_peak_8MPa"
    [[nodiscard]] std::string fitted_name() const;  ///< of the same in [fitted]: "confined_strength_8MPa"
    [[nodiscard]] std::string symbol() const;       ///< "first peak at 8 MPa"
    [[nodiscard]] std::string test() const;         ///< brazilian, tension, bend, uniaxial, triaxial
    /// Met by scaling the grains.
    [[nodiscard]] bool is_elastic() const { return kind.name == "young_modulus" || kind.name == "poisson_ratio"; }
    [[nodiscard]] double usual_deviation() const;  ///< of its value, by its kind
    [[nodiscard]] double log_deviation() const { return deviation / value; }
    [[nodiscard]] std::string text(double value_in_si) const;  ///< with the unit: "8.8 MPa"
};

/// A target of the name, without a value. \throws InputError naming `where` if there is none
Target target_of(const std::string& name, const std::string& where);

/// The rows of [targets]; none without that table. \throws InputError naming file and key of what is wrong
std::vector<Target> given_targets(const TomlFile& file);

/// The rows of [targets]; without that table the laboratory's values: E, ν, Brazilian and uniaxial strength, and the first peak
/// at a confining pressure on the line σ1 = UCS + b σ3, with b of the friction angle, or of cohesion and UCS; predicted are the
/// first peak at further pressures, direct tension, crack thresholds and, if it was measured, K_IC. \throws InputError naming
/// file and key of what is wrong or missing
std::vector<Target> targets_of(const Material& rock, const TomlFile& file, double confining_pressure,
                               const std::vector<double>& predicted_pressures);

/// How far the UCS of the line of C and φ, 2 C √b, is off the measured UCS, a part; 0 if C or φ is not given.
double disagreement(const Material& rock);

/// "" or, for messages and names, the pressure as "8MPa".
std::string pressure_text(double pascal);

}  // namespace graincrack::calibrate
