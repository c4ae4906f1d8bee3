// A rock that costs nothing: strengths and moduli as smooth functions of the calibration parameters, with the scatter of real
// specimens, in place of mesher and solver.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "post/calibrate/decide.hpp"
#include "post/calibrate/target.hpp"

namespace graincrack::test {

/// Of Augig granite's kind. Its means are exact at any point; a run adds the scatter of its specimen and a part of its own.
struct SyntheticRock {
    double tensile_exponent = 0.8;     ///< d ln σt/d ln tc, Gf and the open shear strength in its ratio to tc held
    double energy_exponent = 0.15;     ///< d ln σt/d ln Gf
    double open_shear_exponent = 0.1;  ///< d ln σt/d ln (shear strength of open contacts)
    double cohesion_exponent = 0.9;    ///< d ln UCS/d ln cc
    double friction_gain = 0.8;        ///< dφ/dφc
    double friction_limit = 90;        ///< φ of the assemblage never exceeds it, degrees
    double disc_scatter = 0.14;
    double confined_scatter = 0.08;
    double uniaxial_scatter = 0.05;
    std::uint64_t variety = 1;  ///< other specimens

    using Values = std::array<double, calibrate::n_parameters>;
    static constexpr double degree = std::numbers::pi / 180;

    /// Strength without scatter.
    [[nodiscard]] double strength(const std::string& test, double pressure, const Values& v) const {
        if (test == "brazilian") {
            return 8.8e6 * std::pow(v[2] / 24e6, tensile_exponent - open_shear_exponent) * std::pow(v[5] / 87, energy_exponent) *
                   std::pow(v[6] / 7.8e6, open_shear_exponent);
        }
        const double ucs =
            122e6 * std::pow(v[3] / 70e6, cohesion_exponent) * std::exp(1.2 * (v[4] - 42 * degree)) * std::pow(v[2] / 24e6, 0.02);
        const double phi = std::min(52 * degree + friction_gain * (v[4] - 42 * degree), friction_limit * degree);
        return ucs + pressure * (1 + std::sin(phi)) / (1 - std::sin(phi));
    }

    /// A finished run. \param wanted by a calibration of `rock`
    [[nodiscard]] calibrate::FinishedRun run(const Material& rock, const calibrate::WantedRun& wanted, double max_strain) const {
        if (wanted.test == "tension") return tension(rock, wanted);
        const auto values = calibrate::effective_values(rock, wanted.point, calibrate::plane_of(wanted.test));
        calibrate::FinishedRun out;
        out.test = wanted.test;
        out.confining_pressure = wanted.confining_pressure;
        out.seed = wanted.seed;
        out.values = values;
        out.max_strain = wanted.max_strain.value_or(max_strain);
        out.mean_edge = 5.13e-3;
        const double scatter = wanted.test == "brazilian"  ? disc_scatter
                               : wanted.test == "triaxial" ? confined_scatter
                                                           : uniaxial_scatter;
        const double specimen = normal(wanted.test, wanted.seed, 0, {});
        const double own = normal(wanted.test, wanted.seed, wanted.confining_pressure, values);
        // Most of the scatter is the specimen's: the same at all points.
        const double factor = 1 + scatter * (0.85 * specimen + std::sqrt(1 - 0.85 * 0.85) * own);
        out.strength = strength(wanted.test, wanted.confining_pressure, values) * std::max(0.1, factor);
        if (wanted.test == "uniaxial") add_moduli(rock, wanted, out);
        return out;
    }

private:
    static calibrate::FinishedRun tension(const Material& rock, const calibrate::WantedRun& wanted) {
        calibrate::FinishedRun out;
        out.test = wanted.test;
        out.seed = wanted.seed;
        out.values = calibrate::effective_values(rock, wanted.point, calibrate::plane_of(wanted.test));
        out.strength = wanted.notched ? 4e6 : 11e6;
        if (wanted.notched) out.mode_i_toughness = 1.6e6;
        return out;
    }
    /// Of assemblages with a contact length of 0.68 /mm, 1 % softer than predicted.
    void add_moduli(const Material& rock, const calibrate::WantedRun& wanted, calibrate::FinishedRun& out) const {
        const Material grains = calibrate::material_at(rock, wanted.point);
        const auto contact = contact_parameters(grains, PlaneCondition::strain, std::nullopt);
        const auto moduli =
            fpz::assemblage_moduli(grains.rock, PlaneCondition::strain, contact.normal_stiffness, contact.shear_stiffness, 680);
        out.crack_initiation = 0.4 * out.strength;
        out.crack_damage = 0.8 * out.strength;
        out.predicted_young_modulus = moduli.young_modulus;
        out.predicted_poisson_ratio = moduli.poisson_ratio;
        out.young_modulus = moduli.young_modulus * 0.99 * (1 + 0.003 * normal("E", wanted.seed, 0, {}));
        out.poisson_ratio = moduli.poisson_ratio + 0.002 + 0.002 * normal("nu", wanted.seed, 0, {});
    }

    static std::uint64_t mixed(std::uint64_t x) {  // splitmix64
        x += 0x9e3779b97f4a7c15U;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
        return x ^ (x >> 31);
    }
    /// A normal number that belongs to what it is given.
    [[nodiscard]] double normal(const std::string& test, std::int64_t seed, double pressure, const Values& values) const {
        std::uint64_t state = mixed(variety);
        for (const char c : test) state = mixed(state ^ static_cast<std::uint64_t>(c));
        state = mixed(state ^ static_cast<std::uint64_t>(seed));
        const auto add = [&](double value) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            state = mixed(state ^ bits);
        };
        add(pressure);
        for (const double value : values) add(value);
        const double u = (static_cast<double>(mixed(state) >> 11) + 1) * 0x1p-53;
        const double v = static_cast<double>(mixed(state ^ 77) >> 11) * 0x1p-53;
        return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
    }
};

/// Runs what a calibration wants until it ends.
struct Calibration {
    calibrate::Decision decision;
    std::vector<calibrate::FinishedRun> runs;
    std::size_t calls = 0;
    bool asked_twice = false;
};
inline Calibration calibrate_synthetic(const Material& rock, const SyntheticRock& synthetic, const calibrate::Study& study) {
    Calibration out;
    for (out.calls = 1; out.calls < 200; ++out.calls) {
        out.decision = calibrate::decide(rock, study, out.runs);
        if (out.decision.ending != calibrate::Ending::wanted) return out;
        const calibrate::FinishedRuns before(rock, out.runs, study.max_strain);
        for (const auto& wanted : out.decision.wanted) {
            if (before.find(wanted) != nullptr) out.asked_twice = true;
            out.runs.push_back(synthetic.run(rock, wanted, study.max_strain));
        }
    }
    return out;
}

}  // namespace graincrack::test
