// Parts of a calibration, each on numbers with known answers.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>

#include "post/calibrate/optimum.hpp"
#include "post/calibrate/target.hpp"
#include "post/calibrate/verdict.hpp"
#include "post/statistics/statistics.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/normal.hpp"

namespace graincrack {
namespace {

using calibrate::Box;
using calibrate::DesignPoint;
using calibrate::find_optimum;
using calibrate::LocalSurface;
using calibrate::Optimum;
using calibrate::Residual;
using calibrate::sobol_points;

DesignPoint point(double x, double y) { return DesignPoint{{x, y}}; }
const Box unit{point(0, 0), point(1, 1)};

/// Values of a function at design points, with scatter.
template <class Function>
std::vector<double> values_at(const std::vector<DesignPoint>& points, const Function& function, double scatter = 0) {
    test::Normal normal(5);
    std::vector<double> values;
    for (const DesignPoint& p : points) values.push_back(function(p(0), p(1)) + scatter * normal());
    return values;
}

// Jeffreys' prior adds half an outcome to each side of a 2 × 2 table: ln((n₁ + ½)/(n₀ + ½)).
TEST(Logistic, IsFiniteWithoutAnyOfOneKind) {
    const Eigen::MatrixXd factors{{0.0}, {0.0}, {0.0}, {0.0}, {1.0}, {1.0}, {1.0}, {1.0}, {1.0}, {1.0}};
    const Logistic fit = fit_logistic(factors, Eigen::VectorXd{{1, 1, 1, 1, 0, 0, 0, 1, 1, 1}});
    EXPECT_NEAR(fit.logit(Eigen::VectorXd{{0}}), std::log(4.5 / 0.5), 1e-8);
    EXPECT_NEAR(fit.logit(Eigen::VectorXd{{1}}), 0, 1e-8);
}

// Each half of each coordinate has half of the first 2^k numbers, and a later design has other points.
TEST(Design, FillsItsBoxEvenly) {
    const Box box{point(3, 0), point(2, 1)};
    const std::vector<DesignPoint> points = sobol_points(box, 0, 31);
    int lower = 0;
    for (const DesignPoint& p : points) {
        EXPECT_TRUE(box.contains(p));
        if (p(0) < 3) ++lower;
    }
    EXPECT_EQ(lower, 15);
    EXPECT_NE(sobol_points(box, 31, 1)[0], points[0]);
    EXPECT_EQ(sobol_points(box, 7, 2)[0], points[7]);
}

TEST(Box, StaysInItsLimits) {
    const Box limits{point(0, 0), point(1.5, 1)};
    const Box moved = unit.about(point(1, 0.5), 1, limits);
    EXPECT_NEAR(moved.centre(0), 0.5, 1e-12);
    EXPECT_NEAR(moved.centre(1), 0, 1e-12);
    const Box zoomed = unit.about(point(1, 0.5), 0.5, limits);
    EXPECT_NEAR(zoomed.centre(0), 1, 1e-12);
    EXPECT_NEAR(zoomed.half(0), 0.5, 1e-12);
}

TEST(LocalSurface, HasTheTermsThatPredict) {
    const std::vector<DesignPoint> points = sobol_points(unit, 0, 20);
    const auto quadratic = [](double x, double y) { return 2 + 0.5 * x - y + 0.3 * x * x; };
    const auto surface = LocalSurface::fit(unit, points, values_at(points, quadratic, 1e-6));
    ASSERT_TRUE(surface.has_value());
    EXPECT_GE(surface->model().terms.size(), 4U);
    EXPECT_NEAR(surface->value(point(0.7, -0.2)), quadratic(0.7, -0.2), 1e-5);
    EXPECT_NEAR(surface->gradient(point(0.7, -0.2))(0), 0.5 + 0.6 * 0.7, 1e-5);
    EXPECT_NEAR(surface->gradient(point(0.7, -0.2))(1), -1, 1e-5);
    EXPECT_NEAR(surface->model().scatter(), 1e-6, 4e-7);
    // In another box the coordinates of a design point stay the same.
    const Box half{point(0.25, 0), point(0.5, 0.5)};
    const std::vector<DesignPoint> inside = sobol_points(half, 0, 20);
    const auto other = LocalSurface::fit(half, inside, values_at(inside, quadratic, 1e-6));
    EXPECT_NEAR(other->gradient(point(0.3, 0.1))(0), 0.5 + 0.6 * 0.3, 1e-4);
}

TEST(LocalSurface, LeavesOutPointsWithoutAValue) {
    const std::vector<DesignPoint> points = sobol_points(unit, 0, 20);
    std::vector<double> values = values_at(
        points, [](double x, double y) { return x + y; }, 0.1);
    values[3] = std::nan("");
    const auto surface = LocalSurface::fit(unit, points, values);
    EXPECT_EQ(surface->model().n_values, 19);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i != 3) sum += std::pow(values[i] - surface->value(points[i]), 2);
    }
    EXPECT_NEAR(surface->model().scatter(), std::sqrt(sum / (19 - static_cast<double>(surface->model().terms.size()))), 1e-9);
    EXPECT_FALSE(LocalSurface::fit(unit, {points.begin(), points.begin() + 4}, {1, 2, 3, 4}).has_value());
}

/// The plane x + c y.
LocalSurface plane_with(double c) {
    const std::vector<DesignPoint> points = sobol_points(unit, 0, 20);
    const auto plane = [c](double x, double y) { return x + c * y; };
    return *LocalSurface::fit(unit, points, values_at(points, plane, 1e-9));
}
struct Planes {
    LocalSurface first = plane_with(1), second = plane_with(-1);
};

constexpr double nothing_known = 1e3;  // beforehand

// x + y = 0.5 ± 0.1 and x − y = 0.1 ± 0.2: x = 0.3 and y = 0.2, each with a variance of (0.01 + 0.04)/4.
TEST(Optimum, LiesWhereTwoPlanesMeetTheirTargets) {
    const Planes planes;
    const Optimum optimum =
        find_optimum(unit, point(0, 0), {{&planes.first, 0.5, 0.1}, {&planes.second, 0.1, 0.2}}, {}, nothing_known);
    EXPECT_NEAR(optimum.point(0), 0.3, 1e-6);
    EXPECT_NEAR(optimum.point(1), 0.2, 1e-6);
    EXPECT_NEAR(optimum.covariance(0, 0), 0.0125, 1e-6);
    EXPECT_NEAR(optimum.covariance(0, 1), -0.0075, 1e-6);
    EXPECT_NEAR(optimum.condition, 2, 1e-4);
    // Outside of the box the nearest, by weights: at the corner x = 1 both slopes along y must balance.
    const Optimum edge =
        find_optimum(unit, point(0, 0), {{&planes.first, 1.5, 0.1}, {&planes.second, 1.5, 0.1}}, {}, nothing_known);
    EXPECT_NEAR(edge.point(0), 1, 1e-9);
    EXPECT_NEAR(edge.point(1), 0, 1e-6);
    EXPECT_NEAR(edge.deviations[0], -5, 1e-4);
}

// From (0.2, −0.4) ± 1 along (1, 1) towards x + y = 0.5 ± 0.1: of the lack of 0.7, 2/(2 + 0.01) is made up. x − y keeps its
// variance of 2, so that x has a half and that of x + y, 2 · 0.01/2.01, a quarter.
TEST(FirstGuess, IsKeptWhereDataDoNotDetermineIt) {
    const Planes planes;
    const Optimum optimum = find_optimum(unit, point(0.2, -0.4), {{&planes.first, 0.5, 0.1}});
    EXPECT_NEAR(optimum.point(0), 0.2 + 0.35 * 2 / 2.01, 1e-6);
    EXPECT_NEAR(optimum.point(1), -0.4 + 0.35 * 2 / 2.01, 1e-6);
    EXPECT_NEAR(optimum.covariance(0, 0), 0.5 + 0.25 * 0.02 / 2.01, 1e-6);
    EXPECT_TRUE(optimum.is_undetermined(0));
    // A wider first guess determines nothing more.
    const Optimum wide = find_optimum(unit, point(0.2, -0.4), {{&planes.first, 0.5, 0.1}}, {}, 2);
    EXPECT_NEAR(wide.covariance(0, 0), 2, 0.01);
    EXPECT_TRUE(find_optimum(unit, point(0, 0), {{&planes.first, 0.5, 0.9}, {&planes.second, 0.1, 0.9}}, {}, 2)
                    .is_undetermined(0));  // about 0.4 of 4
}

// Draws of two planes, one of which is a target, scatter as the covariance says; so does x − y, which nothing tells but the first
// guess.
TEST(Draws, HaveTheCovarianceOfTheOptimum) {
    const Planes planes;
    const std::vector<Residual> residuals{{&planes.first, 0.1, 0.1}};
    const Optimum optimum = find_optimum(unit, point(0, 0), residuals, {}, 0.2);
    const Box wide{point(0, 0), point(10, 10)};
    const auto draws = draw(wide, optimum, residuals, {&planes.first, nullptr, &planes.second}, 4000);
    std::vector<double> x, sum, difference;
    for (std::size_t i = 0; i < draws.points.size(); ++i) {
        x.push_back(draws.points[i](0));
        sum.push_back(draws.logs[i][0]);
        difference.push_back(draws.logs[i][2]);
        EXPECT_TRUE(std::isnan(draws.logs[i][1]));
    }
    // Three standard errors of a standard deviation of 4000 are 3.4 %.
    EXPECT_NEAR(*sample(x).deviation, std::sqrt(optimum.covariance(0, 0)), 0.034 * 0.15);
    EXPECT_NEAR(*sample(sum).deviation, std::sqrt(0.08 * 0.01 / 0.09), 0.034 * 0.095);
    EXPECT_NEAR(*sample(difference).deviation, 0.2 * std::sqrt(2), 0.034 * 0.29);
}

// Two quantities of the same specimens, which scatter together, are drawn together, and by Student's distribution.
TEST(Draws, CorrelateQuantitiesOfTheSameSpecimens) {
    test::Normal normal(5);
    std::vector<std::vector<double>> factors;
    std::vector<double> first, second;
    for (const DesignPoint& at : sobol_points(unit, 0, 12)) {
        factors.push_back({at(0), at(1)});
        const double of_specimen = normal();
        first.push_back(at(0) + 0.1 * (of_specimen + 0.5 * normal()));
        second.push_back(at(1) + 0.1 * (of_specimen + 0.5 * normal()));
    }
    const std::vector<SurfaceTerm> terms{{{0, 0}}, {{1, 0}}, {{0, 1}}};
    const auto surface = [&](const std::vector<double>& response) {
        const auto located = [](const DesignPoint& at) { return calibrate::Located{{at(0), at(1)}}; };
        return LocalSurface(located, *LinearModel::fit(terms, factors, response), true);
    };
    const LocalSurface a = surface(first);
    const LocalSurface b = surface(second);
    const double together = a.model().residual_correlation(b.model());
    EXPECT_GT(together, 0.5);
    const std::vector<Residual> residuals{{&a, 0, 0.1}};
    const Optimum optimum = find_optimum(unit, point(0, 0), residuals, {}, 1e-6);
    std::vector<double> of_a, of_b;
    for (const auto& logs : draw(unit, optimum, residuals, {&a, &b}, 8000).logs) {
        of_a.push_back(logs[0]);
        of_b.push_back(logs[1]);
    }
    const double r = std::sqrt(fit_line(of_a, of_b)->r_squared);
    EXPECT_GT(r, 0.8 * together);  // each by a scale of its own
    EXPECT_LT(r, together + 0.03);
    const int freedom = a.model().freedom;  // 9: 9/7 times the variance
    EXPECT_NEAR(*sample(of_a).deviation, std::sqrt(a.variance(optimum.point) * freedom / (freedom - 2)),
                0.04 * *sample(of_a).deviation);
}

// A share that falls with x: logit 2 − 8 x, one half at x = 0.25.
TEST(Optimum, KeepsAShare) {
    const Planes planes;
    const Logistic share{Eigen::VectorXd{{2, -8, 0}}};
    const Optimum free = find_optimum(unit, point(0, 0), {{&planes.first, 1, 0.1}, {&planes.second, 1, 0.1}}, {}, nothing_known);
    EXPECT_NEAR(free.point(0), 1, 1e-6);
    const Optimum kept = find_optimum(unit, point(0, 0), {{&planes.first, 1, 0.1}, {&planes.second, 1, 0.1}}, {{&share, 0.5}});
    EXPECT_LT(kept.point(0), 0.45);
    EXPECT_GT(kept.point(0), 0.25);
}

using calibrate::Measures;
using calibrate::target_of;

TEST(CalibrationTarget, ReadsCrackThresholdsOfStrainGaugesUnlessTheCountIsAskedFor) {
    const Measures measures{
        {"crack_initiation_MPa", 55}, {"crack_damage_MPa", 98}, {"crack_damage_2d_MPa", 110}, {"crack_initiation_count_MPa", 80}};
    const auto value = [&](const std::string& name) { return target_of(name, "targets").read(measures); };
    EXPECT_EQ(value("crack_initiation"), 55e6);
    EXPECT_EQ(value("crack_damage"), 98e6);
    EXPECT_EQ(value("crack_initiation_count"), 80e6);
    EXPECT_TRUE(std::isnan(target_of("crack_damage", "targets").read({{"crack_damage_2d_MPa", 110}})));
}

TEST(CalibrationTarget, ReadsToughnessOfHalfDiscs) {
    calibrate::Target target = target_of("toughness", "targets");
    target.value = 1.5e6;
    EXPECT_EQ(target.test(), "bend");
    EXPECT_DOUBLE_EQ(target.read({{"mode_i_toughness_MPa.m^0.5", 1.2}}), 1.2e6);
    EXPECT_TRUE(std::isnan(target.read({{"strength_MPa", 1.2}})));
    EXPECT_DOUBLE_EQ(target.usual_deviation(), 0.15e6);
    EXPECT_EQ(target.text(target.value), "1.5 MPa√m");
    EXPECT_EQ(target.symbol(), "K_IC");
    EXPECT_EQ(target.fitted_name(), "mode_i_toughness");
}

TEST(CalibrationTarget, HasTheLogarithmOfWhatAFallLeaves) {
    calibrate::Target fall = target_of("drop_50MPa", "targets");
    fall.value = 0.42;
    fall.deviation = 0.1;
    EXPECT_DOUBLE_EQ(fall.logarithm(-0.1), std::log(1.1));
    EXPECT_NEAR(fall.of_logarithm(std::log(1.1)), -0.1, 1e-12);
    EXPECT_DOUBLE_EQ(fall.log_deviation(), 0.1 / 0.58);
    const calibrate::Target strength = target_of("uniaxial", "targets");
    EXPECT_NEAR(strength.of_logarithm(strength.logarithm(122e6)), 122e6, 1);
    EXPECT_TRUE(std::isnan(strength.logarithm(-1)));
}

TEST(CalibrationTarget, IsNotTakenForOneWithWhichItsNameBegins) {
    std::string text;
    for (const char* name : {"crack_initiation_8MPa", "crack_initiation_count", "crack_initiation_count_8MPa"}) {
        const calibrate::Target target = target_of(name, "targets");
        text +=
            fmt::format("{}: {} at {} Pa: {}\n", target.name(), target.property.name, target.confining_pressure, target.symbol());
    }
    test::expect_golden(text);
}

TEST(Outcomes, HaveAVerdictByTheWholeIntervalAndTheMean) {
    calibrate::Target target = target_of("uniaxial", "test");
    target.value = 100e6;
    target.deviation = 5e6;
    std::string text;
    const auto add = [&](const std::vector<double>& strengths) {
        std::vector<Measures> runs;
        for (const double each : strengths) runs.push_back({{"first_peak_MPa", each}});
        std::vector<const Measures*> list;
        for (const Measures& run : runs) list.push_back(&run);
        const calibrate::Outcome outcome = calibrate::outcome_of(target, list, calibrate::Study{});
        text +=
            fmt::format("{} MPa: {}: {}\n", fmt::join(strengths, ", "), outcome.verdict, outcome.is_met() ? "met" : "not met");
        return outcome.ours->mean;
    };
    add({99.9, 100.1});
    add({97, 101, 103});  // ± 7.6
    add({94, 95.5});
    EXPECT_EQ(add({30, 170}).low, 0);  // 100 ± 890
    target.use = calibrate::Use::predict;
    add({97, 101, 103});
    test::expect_golden(text);
}

}  // namespace
}  // namespace graincrack
