// Targets of a calibration: what a rock has in the laboratory and the assemblage shall have too, in one table.
#pragma once

#include <string>
#include <vector>

#include "share/material.hpp"

namespace graincrack::calibrate {

/// What is asked of a target: that it is met, or that it is predicted and compared.
enum class Role { fitted, predicted };

struct Target {
    std::string name;               ///< "tensile_strength"; "confined_strength"
    std::string symbol;             ///< in reports: "σt", "σ1 at 8 MPa"
    std::string column;             ///< of the table of runs
    std::string test;               ///< brazilian, uniaxial, triaxial, tension
    double confining_pressure = 0;  ///< Pa
    double value = 0;               ///< SI; NaN for a prediction that the laboratory has no value for
    double si = 1;                  ///< the unit of reports in SI
    std::string unit;               ///< of reports
    double bound = 0;               ///< how far the confirmation may be off: a part, of ν absolute
    bool absolute = false;          ///< the bound is no part
    Role role = Role::fitted;
    bool notched = false;  ///< its specimens have a notch
    /// The bound as an amount of the value's unit.
    [[nodiscard]] double tolerance() const { return absolute ? bound : bound * value; }
};

/// Names of targets, for which `target` returns the row.
inline constexpr const char* confined_strength = "confined_strength";

/// What the targets of a rock depend on, beside its laboratory values.
struct TargetOptions {
    double confining_pressure = 8e6;                     ///< Pa, at which friction is fitted
    std::vector<double> predicted_pressures{4e6, 20e6};  ///< Pa
};

/// The table. The strength under pressure is that of the line σ1 = UCS + b σ3, b of the friction angle, or of cohesion and UCS.
/// \throws InputError naming the laboratory value that is missing
std::vector<Target> targets_of(const Material& rock, const TargetOptions& options);
/// \pre there is one of this name
const Target& target(const std::vector<Target>& targets, const std::string& name);

/// The slope b = (1 + sin φ)/(1 − sin φ) of the laboratory's line.
double laboratory_slope(const Material& rock);
/// How far the UCS of the line of C and φ, 2 C √b, is off the measured UCS, a part; 0 if C or φ is not given.
double disagreement(const Material& rock);

}  // namespace graincrack::calibrate
