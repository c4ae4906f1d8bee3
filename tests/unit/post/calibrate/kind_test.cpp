// Calibrations that begin with the surface of a kind, on rocks whose contact values are known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "post/calibrate/kind_prior.hpp"
#include "post/calibrate/report.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/normal.hpp"
#include "tests/support/synthetic_kind.hpp"

namespace graincrack::calibrate {
namespace {

constexpr double tc = 9e6;
constexpr double scatter = 0.07;       // of single specimens
constexpr double rock_scatter = 0.04;  // of what a rock differs from its kind

struct Measured {
    const char* test;      ///< label of the test that measures it
    const char* target;    ///< name of the target
    const char* property;  ///< in the table of the kind
    const char* column;
    double pressure;  ///< Pa
};
const Measured all_measured[] = {{"brazilian", "brazilian", "brazilian", "tensile_strength_MPa", 0},
                                 {"tension", "direct_tension", "direct_tension", "tensile_strength_MPa", 0},
                                 {"uniaxial", "uniaxial", "uniaxial", "first_peak_MPa", 0},
                                 {"triaxial8MPa", "first_peak_8MPa", "first_peak", "first_peak_MPa", 8e6},
                                 {"triaxial20MPa", "first_peak_20MPa", "first_peak", "first_peak_MPa", 20e6}};

/// ln of a quantity over tc.
double kind_value(const std::string& property, const KindCoordinates& at, double pressure_over_tc) {
    const double c = std::log(at.cohesion / 5);
    const double f = (at.friction_angle - 0.77) / 0.14;
    if (property == "brazilian") return -0.1 + 0.05 * c;
    if (property == "direct_tension") return -0.35 + 0.03 * c;
    const double ucs = 2.9 + 0.45 * c + 0.1 * f;
    if (property == "uniaxial") return ucs;
    return ucs + 0.5 + (0.35 + 0.1 * f - 0.1 * c) * std::log(pressure_over_tc / 1.5) + 0.08 * f;
}

KindCoordinates coordinates(double ratio, double angle) { return {1, 1, ratio, angle, 0.5, 0.71, 80}; }

/// 40 points with two pressures each; three rocks differ from it by rock_scatter.
std::shared_ptr<const KindSurface> kind() {
    test::Normal normal(11);
    std::vector<KindRow> rows;
    const auto add = [&](const std::string& point, const KindCoordinates& at, bool is_rock) {
        for (const Measured& m : all_measured) {
            const double pressure = m.pressure > 0 ? m.pressure / tc * (0.3 + 1.6 * normal.uniform()) : 0;
            const double off = is_rock ? rock_scatter * (normal.uniform() < 0.5 ? 1 : -1) : scatter * normal();
            rows.push_back({"granite", point, is_rock, at, pressure, m.property,
                            std::exp(kind_value(m.property, at, pressure) + off), is_rock ? 1e6 : 1.0});
        }
    };
    const Box box{DesignPoint{{0, 0.77}}, DesignPoint{{1.3, 0.4}}};
    for (const DesignPoint& at : sobol_points(box, 0, 40)) {
        add(fmt::format("d{}", rows.size()), coordinates(5 * std::exp(at(0)), at(1)), false);
    }
    for (int i = 0; i < 3; ++i) add(fmt::format("rock {}", i), coordinates(5, 0.77), true);
    return std::make_shared<const KindSurface>(rows, "granite");
}

/// A rock of the kind: what its contacts have, by which each quantity is off, and the laboratory's values of it.
struct Rock {
    explicit Rock(std::uint32_t number) : normal(number) {
        truth = coordinates(5 * std::exp(0.7 * (2 * normal.uniform() - 1)), 0.77 + 0.12 * (2 * normal.uniform() - 1));
        strength = tc * std::exp(0.25 * (2 * normal.uniform() - 1));
        for (const Measured& m : all_measured) off[m.property] = rock_scatter * normal();
        problem.kind = kind();
        problem.young_modulus = 60e9;
        problem.poisson_ratio = 0.25;
        Material& rock = problem.rock;
        rock.rock = {60e9, 0.25, 2650, 1.3e6, 2.6e6, 9e6};
        rock.law = "cohesive-frictional";
        rock.grains.grain_size = 3e-3;
        rock.ratios.fracture_energy = 0.71;
        rock.ratios.mode_ii_fracture_energy = 80;
        rock.contact.residual_friction_angle = 0.5;
        problem.parameters = {{"contact.tensile_strength", true, 6e6, 13e6, 3e6, 26e6, 9e6},
                              {"ratios.cohesion", true, 2.5, 10, 1, 20, 5},
                              {"contact.friction_angle", false, 0.6, 0.94, 0.3, 1.2, 0.77}};
        for (const Measured& m : all_measured) {
            Target t = target_of(m.target, "targets");
            t.value = mean_of(m);
            t.deviation = t.usual_deviation();
            const bool fits = m.pressure < 20e6 && t.name() != "direct_tension";
            if (fits) t.value *= std::exp(t.log_deviation() * normal());
            t.use = fits ? Use::fit : Use::predict;
            problem.targets.push_back(t);
        }
    }
    [[nodiscard]] double value(const Measured& m, const KindCoordinates& at, double unit) const {
        return unit * std::exp(kind_value(m.property, at, m.pressure / unit) + off.at(m.property));
    }
    [[nodiscard]] double mean_of(const Measured& m) const { return value(m, truth, strength); }
    [[nodiscard]] Measures measure(const RequestedRun& run) const {
        std::map<std::string, double> point(run.point.begin(), run.point.end());
        const KindCoordinates at = coordinates(point["ratios.cohesion"], point["contact.friction_angle"]);
        Measures measures;
        for (const Measured& m : all_measured) {
            if (run.test.label() != m.test) continue;
            test::Normal own(static_cast<std::uint32_t>(run.seed));
            measures[m.column] = 1e-6 * value(m, at, point["contact.tensile_strength"]) * std::exp(scatter * own());
        }
        return measures;
    }

    test::Normal normal;
    KindCoordinates truth;
    double strength = 0;
    std::map<std::string, double> off;
    Problem problem;
};

/// Finishes the requested runs, all or but one of each request, until it has decided.
Decision decide_on(const Rock& rock, bool one_at_a_time, std::size_t& n_runs) {
    std::map<std::string, Measures> finished;
    const auto name = [](const RequestedRun& run) { return run.test.label() + run.label + std::to_string(run.seed); };
    while (true) {
        Decision decision = decide(rock.problem, [&](const RequestedRun& run) -> const Measures* {
            const auto found = finished.find(name(run));
            return found == finished.end() ? nullptr : &found->second;
        });
        n_runs = finished.size();
        if (decision.ending != Ending::requested) return decision;
        if (one_at_a_time) decision.requested = {decision.requested.back()};
        for (const RequestedRun& run : decision.requested) finished[name(run)] = rock.measure(run);
    }
}

// The truth lies within the 95 % intervals of the parameters, and within 95 % of the draws of what was not fitted, in 95 ± 5 % of
// 60 rocks each.
TEST(CalibrationOfAKind, HasIntervalsThatHoldTheTruth) {
    std::map<std::string, int> held;
    std::vector<double> runs;
    int calibrated = 0;
    for (std::uint32_t i = 0; i < 60; ++i) {
        const Rock rock(1000 + i);
        std::size_t n_runs = 0;
        const Decision decision = decide_on(rock, false, n_runs);
        runs.push_back(static_cast<double>(n_runs));
        calibrated += decision.ending == Ending::calibrated ? 1 : 0;
        const Fit& fit = decision.fit.value();
        const std::vector<double> planted{rock.strength, rock.truth.cohesion, rock.truth.friction_angle};
        for (Eigen::Index k = 0; k < 3; ++k) {
            const Parameter& p = rock.problem.parameters[static_cast<std::size_t>(k)];
            const double off = fit.optimum.point(k) - p.coordinate(planted[static_cast<std::size_t>(k)]);
            if (std::abs(off) <= fit.optimum.half_interval(k)) ++held[p.key];
        }
        std::vector<const LocalSurface*> surfaces;
        for (const Response& r : fit.responses) surfaces.push_back(r.surface ? &*r.surface : nullptr);
        const Draws draws = draw(limits_of(rock.problem.parameters), fit.optimum, residuals_of(fit.responses), surfaces, 400);
        for (const Prediction& p : predictions_of(fit, draws)) {
            if (p.target.use == Use::fit || !std::isfinite(p.target.value)) continue;
            if (p.target.value >= *p.rock.low && p.target.value <= *p.rock.high) ++held[p.target.name()];
            EXPECT_LT(*p.specimen.low, *p.half_of_specimens.low);
        }
    }
    EXPECT_EQ(held.size(), 5U);
    for (const auto& [name, n] : held) {
        EXPECT_GE(n, 54) << name;
        RecordProperty(name, n);
    }
    EXPECT_GE(calibrated, 50);
    EXPECT_LE(median(runs), 70);
}

TEST(CalibrationOfAKind, DoesNotDependOnTheOrderInWhichRunsEnd) {
    const Rock rock(7);
    std::size_t together = 0, in_turn = 0;
    const Decision decision = decide_on(rock, false, together);
    const Decision other = decide_on(rock, true, in_turn);
    EXPECT_EQ(decision.point, other.point);
    EXPECT_EQ(decision.reason, other.reason);
    EXPECT_EQ(together, in_turn);
    // No run has been made where the kind gives the first guess.
    EXPECT_EQ(decision.steps.front().stage, "kind");
}

// Bridges are a coordinate of the surface, their stiffness is none.
TEST(KindPrior, KnowsBridgesAndNamesWhatItDoesNotKnow) {
    const auto surface = std::make_shared<const KindSurface>(test::SyntheticKind{}.rows(70), "granite");
    const Material rock = read_material("granite-crystals");
    std::string text;
    for (const std::string key : {"ratios.bridging_strength", "ratios.open_shear_strength"}) {
        const KindPrior prior(surface, rock, {{key, true, 0.4, 0.8, 0.3, 0.9, 0.6}}, Study{});
        text += key + ": \"" + prior.lacks({}) + "\"\n";
    }
    test::expect_golden(text);
}

}  // namespace
}  // namespace graincrack::calibrate
