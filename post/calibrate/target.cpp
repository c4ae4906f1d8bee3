#include "post/calibrate/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "share/error.hpp"
#include "share/mohr_coulomb.hpp"

namespace graincrack::calibrate {

namespace {

double needed(const Material& rock, const std::string& key) {
    const auto found = rock.laboratory.find(key);
    if (found != rock.laboratory.end()) return found->second;
    throw InputError(fmt::format("{}: [laboratory] has no {}; a calibration needs it", rock.file.string(), key));
}

Target strength(const std::string& name, const std::string& symbol, const std::string& test, double pressure, double value,
                Role role) {
    const bool compression = test == "uniaxial" || test == "triaxial";
    return {name,  symbol,   compression ? "peak_compressive_stress_MPa" : "tensile_strength_MPa",
            test,  pressure, value,
            1e6,   "MPa",    0.05,
            false, role,     false};
}

}  // namespace

double laboratory_slope(const Material& rock) {
    const auto angle = rock.laboratory.find("friction_angle");
    if (angle != rock.laboratory.end()) return mohr_coulomb_slope(angle->second);
    const auto cohesion = rock.laboratory.find("cohesion");
    if (cohesion != rock.laboratory.end()) return std::pow(needed(rock, "compressive_strength") / (2 * cohesion->second), 2);
    throw InputError(
        fmt::format("{}: [laboratory] has neither friction_angle nor cohesion; a calibration needs one", rock.file.string()));
}

double disagreement(const Material& rock) {
    const auto angle = rock.laboratory.find("friction_angle");
    const auto cohesion = rock.laboratory.find("cohesion");
    if (angle == rock.laboratory.end() || cohesion == rock.laboratory.end()) return 0;
    return 2 * cohesion->second * std::sqrt(mohr_coulomb_slope(angle->second)) / needed(rock, "compressive_strength") - 1;
}

std::vector<Target> targets_of(const Material& rock, const TargetOptions& options) {
    // Bounds: what laboratories can tell apart. E of one rock scatters by 2 to 5 %, ν by 0.02; strengths by 5 to 15 %, so that
    // the mean of ten tests is known to about 5 %.
    const double ucs = needed(rock, "compressive_strength");
    const double slope = laboratory_slope(rock);
    std::vector<Target> targets{
        {"young_modulus", "E", "young_modulus_GPa", "uniaxial", 0, needed(rock, "young_modulus"), 1e9, "GPa", 0.02, false,
         Role::fitted},
        {"poisson_ratio", "ν", "poisson_ratio", "uniaxial", 0, needed(rock, "poisson_ratio"), 1, "", 0.015, true, Role::fitted},
        strength("tensile_strength", "σt", "brazilian", 0, needed(rock, "tensile_strength"), Role::fitted),
        strength("compressive_strength", "UCS", "uniaxial", 0, ucs, Role::fitted)};
    const auto confined = [&](double pressure, Role role) {
        targets.push_back(strength(confined_strength, fmt::format("σ1 at {:g} MPa", pressure / 1e6), "triaxial", pressure,
                                   ucs + slope * pressure, role));
    };
    confined(options.confining_pressure, Role::fitted);
    for (const double pressure : options.predicted_pressures) confined(pressure, Role::predicted);
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    targets.push_back(strength("direct_tensile_strength", "direct tensile strength", "tension", 0, unknown, Role::predicted));
    targets.push_back({"mode_i_toughness", "K_IC", "mode_i_toughness_MPa.m^0.5", "tension", 0, rock.rock.mode_i_toughness, 1e6,
                       "MPa √m", 0.1, false, Role::predicted, true});
    targets.push_back(
        strength("crack_initiation", "crack initiation by count of cracks", "uniaxial", 0, unknown, Role::predicted));
    targets.push_back(strength("crack_damage", "crack damage by reversal of volume", "uniaxial", 0, unknown, Role::predicted));
    return targets;
}

const Target& target(const std::vector<Target>& targets, const std::string& name) {
    return *std::find_if(targets.begin(), targets.end(), [&](const Target& t) { return t.name == name; });
}

}  // namespace graincrack::calibrate
