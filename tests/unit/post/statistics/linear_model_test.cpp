// Linear models on numbers with known answers; Table 7 of the paper is in tests/unit/post/ccd.
#include "post/statistics/linear_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/normal.hpp"

namespace graincrack {
namespace {

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

TEST(LinearModel, AnUpdateIsAFitWithOneObservationMore) {
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
TEST(LinearModel, RestrictedLikelihoodDrawsToZeroWhatIsNotThere) {
    Observations data(60);
    const auto fit = [&] { return LinearModel::fit_restricted(quadratic_terms(2), 3, data.factors, data.response).value(); };
    const LinearModel flat = fit();
    EXPECT_LT(flat.coefficients.tail(3).norm(), 0.02);
    EXPECT_NEAR(flat.scatter(), 0.1, 0.03);
    for (std::size_t i = 0; i < 60; ++i) data.response[i] += std::pow(data.factors[i][0], 2);
    EXPECT_NEAR(fit().coefficients(4), 1, 0.1);
    EXPECT_FALSE(LinearModel::fit_restricted(quadratic_terms(2), 3, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {1, 2, 3, 4}));
}

}  // namespace
}  // namespace graincrack
