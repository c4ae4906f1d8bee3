#include "post/statistics/statistics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include "post/statistics/linear_model.hpp"
#include "tests/support/normal.hpp"

namespace graincrack {
namespace {

TEST(Statistics, HaveStudentsQuantilesOfTables) {
    EXPECT_NEAR(student_t_95(1), 12.706205, 1e-6);  // printed tables of t(0.975)
    EXPECT_NEAR(student_t_95(7), 2.364624, 1e-6);
}

TEST(Statistics, HaveMeanDeviationAndIntervalOfASample) {
    const std::array<double, 4> values{2, 4, 4, 6};
    const Sample s = sample(values);
    EXPECT_DOUBLE_EQ(s.mean.value, 4);
    EXPECT_NEAR(*s.deviation, std::sqrt(8.0 / 3), 1e-12);
    EXPECT_NEAR(*s.mean.low, 4 - 3.182446 * std::sqrt(8.0 / 3) / 2, 1e-6);  // t(0.975, 3) = 3.182446
    const Sample one = sample(std::array<double, 1>{3});
    EXPECT_DOUBLE_EQ(one.mean.value, 3);
    EXPECT_FALSE(one.deviation.has_value());
    EXPECT_FALSE(one.mean.low.has_value());
}

TEST(Statistics, FitALineWithVariances) {
    const std::array<double, 4> x{0, 1, 2, 3};
    const std::array<double, 4> y{1, 3, 4, 8};  // by hand: slope 2.2, intercept 0.7, scatter 1.8, Sxx 5
    const auto line = fit_line(x, y);
    ASSERT_TRUE(line.has_value());
    EXPECT_NEAR(line->slope, 2.2, 1e-12);
    EXPECT_NEAR(line->intercept, 0.7, 1e-12);
    EXPECT_NEAR(line->slope_variance, 1.8 / 2 / 5, 1e-12);
    EXPECT_NEAR(line->intercept_variance, 0.9 * (0.25 + 1.5 * 1.5 / 5), 1e-12);
    EXPECT_NEAR(line->covariance, -0.9 * 1.5 / 5, 1e-12);
    EXPECT_NEAR(line->r_squared, 1 - 1.8 / 26, 1e-12);
    EXPECT_EQ(line->freedom, 2);
    EXPECT_FALSE(fit_line(std::array<double, 2>{1, 1}, std::array<double, 2>{1, 2}).has_value());
}

struct Observations {
    std::vector<std::vector<double>> factors;
    std::vector<double> response;
    /// 2 + x1 − 0.5 x2, with scatter.
    explicit Observations(int n) {
        test::Normal normal(3);
        for (int i = 0; i < n; ++i) {
            factors.push_back({normal(), normal()});
            response.push_back(2 + factors.back()[0] - 0.5 * factors.back()[1] + 0.1 * normal());
        }
    }
};

const std::vector<SurfaceTerm> plane{{{0, 0}}, {{1, 0}}, {{0, 1}}};

TEST(LinearModel, UpdatesAsAFitWithOneObservationMore) {
    const Observations all(20);
    Observations first(19);
    LinearModel updated = LinearModel::fit(plane, first.factors, first.response).value();
    updated.update(all.factors.back(), all.response.back(), 1);
    const LinearModel fitted = LinearModel::fit(plane, all.factors, all.response).value();
    EXPECT_NEAR((updated.coefficients - fitted.coefficients).norm(), 0, 1e-12);
    EXPECT_NEAR((updated.inverse - fitted.inverse).norm(), 0, 1e-12);
    EXPECT_EQ(updated.n_values, 20);
}

// What bends nothing is drawn to 0; a square that is there stays.
TEST(LinearModel, ShrinksTermsThatAreNotThere) {
    Observations data(60);
    const auto fit = [&] { return LinearModel::fit_restricted(quadratic_terms(2), 3, data.factors, data.response, {}).value(); };
    const LinearModel flat = fit();
    EXPECT_LT(flat.coefficients.tail(3).norm(), 0.02);
    EXPECT_NEAR(flat.scatter(), 0.1, 0.03);
    for (std::size_t i = 0; i < 60; ++i) data.response[i] += std::pow(data.factors[i][0], 2);
    EXPECT_NEAR(fit().coefficients(4), 1, 0.1);
    EXPECT_FALSE(LinearModel::fit_restricted(quadratic_terms(2), 3, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {1, 2, 3, 4}, {}));
}

// Each specimen observed twice, with nearly the same result, tells hardly more than observed once.
TEST(LinearModel, TakesObservationsOnOneSpecimenTogether) {
    const Observations once(40);
    Observations twice = once;
    std::vector<std::string> specimens;
    for (int i = 0; i < 80; ++i) specimens.push_back(std::to_string(i % 40));
    twice.factors.insert(twice.factors.end(), once.factors.begin(), once.factors.end());
    for (int i = 0; i < 40; ++i) twice.response.push_back(once.response[i] + (i % 2 == 0 ? 0.02 : -0.02));
    const auto fit = [](const Observations& data, const std::vector<std::string>& of) {
        return LinearModel::fit_restricted(plane, 3, data.factors, data.response, of).value();
    };
    const LinearModel one = fit(once, {});
    const LinearModel together = fit(twice, specimens);
    EXPECT_NEAR(together.standard_error(1), one.standard_error(1), 0.08 * one.standard_error(1));
    EXPECT_LT(fit(twice, {}).standard_error(1), 0.8 * one.standard_error(1));
    EXPECT_NEAR(together.scatter(), one.scatter(), 0.1 * one.scatter());
}

}  // namespace
}  // namespace graincrack
