#include "mesher/fabric/strength_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "mesher/plane/random_numbers.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The Weibull modulus of greatest likelihood: Σ sᵐ ln s / Σ sᵐ − 1/m = mean of ln s.
double fitted_modulus(const std::vector<double>& factors) {
    std::vector<double> logarithms;
    for (const double s : factors) logarithms.push_back(std::log(s));
    const double logs = mean_of(logarithms);
    double low = 0.1;
    double high = 1000;
    while (high / low > 1 + 1e-9) {
        const double m = std::sqrt(low * high);
        double powers = 0, weighted = 0;
        for (const double s : factors) {
            powers += std::pow(s, m);
            weighted += std::pow(s, m) * std::log(s);
        }
        (weighted / powers - 1 / m < logs ? low : high) = m;
    }
    return low;
}

/// Mean of the products of two equally long lists.
double mean_product(const std::vector<double>& x, const std::vector<double>& y) {
    return std::inner_product(x.begin(), x.end(), y.begin(), 0.0) / static_cast<double>(x.size());
}

TEST(StrengthField, HasTheMeanAndModulusInAHundredThousandContacts) {
    Specimen s = mesh(rectangle_of(67000));
    EXPECT_EQ(s.contact_strength_factor.size(), 0U) << "none unless requested";
    ASSERT_NEAR(static_cast<double>(s.n_contacts()), 1e5, 1e3);
    const std::vector<int> crystals = own_crystals(s);
    for (const double modulus : {1.5, 5.0, 20.0}) {
        assign_strength_factors(s, crystals, 0, {modulus, {}, {}});
        ASSERT_EQ(s.contact_strength_factor.size(), s.n_contacts());
        // Four standard errors of the mean are 0.009 at m = 1.5; 0.8 % is four times 0.78/√1e5 of the modulus.
        EXPECT_NEAR(mean_of(s.contact_strength_factor), 1, 0.01) << modulus;
        EXPECT_NEAR(fitted_modulus(s.contact_strength_factor) / modulus, 1, 0.03) << modulus;
    }
    // Correlated over half of a per cent of the height: the mean over the specimen is that over seeds.
    assign_strength_factors(s, crystals, 0, {5, 0.8e-3, {}});
    EXPECT_NEAR(mean_of(s.contact_strength_factor), 1, 0.01);
    EXPECT_NEAR(fitted_modulus(s.contact_strength_factor) / 5, 1, 0.03);
}

TEST(StrengthField, HasTheFactorsOfItsQuantiles) {
    EXPECT_NEAR(weibull_factor(std::log(0.5), 2), std::sqrt(std::numbers::ln2) / (0.5 * std::sqrt(std::numbers::pi)), 1e-14);
    EXPECT_NEAR(weibull_factor(-1, 5), 1 / std::tgamma(1.2), 1e-14);
}

// The autocorrelation exp(−d/L) of the field and of the factors, over one realisation 1,000 lengths wide.
TEST(StrengthField, HasAnExponentialAutocorrelation) {
    constexpr double length = 0.01;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const GaussianField field(length, seed);
        RandomNumbers random(seed);
        for (const double distance : {0.5, 1.0, 2.0}) {
            std::vector<double> z[2];
            for (int i = 0; i < 20000; ++i) {
                const Point at{1000 * length * random.uniform(), 1000 * length * random.uniform()};
                const double direction = 2 * std::numbers::pi * random.uniform();
                z[0].push_back(field(at));
                z[1].push_back(field(at + (distance * length) * Point{std::cos(direction), std::sin(direction)}));
            }
            const double variance = mean_product(z[0], z[0]);
            EXPECT_NEAR(mean_of(z[0]), 0, 0.03);
            EXPECT_NEAR(variance, 1, 0.04);
            std::vector<double> squares;
            for (const double value : z[0]) squares.push_back(value * value);
            EXPECT_NEAR(mean_product(squares, squares) / (variance * variance), 3, 0.15);
            const double correlation = mean_product(z[0], z[1]) / variance;
            EXPECT_NEAR(correlation, std::exp(-distance), 0.03) << "seed " << seed << ", distance " << distance;
        }
    }
}

TEST(StrengthField, HasOneFactorOnAGrainBoundaryWhateverTheElements) {
    for (const std::optional<double> correlation : {std::optional<double>{}, std::optional<double>{0.01}}) {
        Request request = rectangle_of(1122);
        request.fabric.strength = {5, correlation, {}};
        const Specimen coarse = mesh(request);
        EXPECT_EQ(mesh(request).contact_strength_factor, coarse.contact_strength_factor);
        request.fabric.elements_per_edge = 3;
        const Specimen fine = mesh(request);
        ASSERT_EQ(fine.n_contacts(), 3 * coarse.n_contacts());
        for (std::size_t c = 0; c < fine.n_contacts(); ++c) {
            const auto boundary = static_cast<std::size_t>(fine.contact_grain_boundary[c]);
            EXPECT_EQ(fine.contact_strength_factor[c], coarse.contact_strength_factor[boundary]);
        }
        request.fabric.strength.seed = request.seed;
        EXPECT_EQ(mesh(request).contact_strength_factor, fine.contact_strength_factor);
        request.fabric.strength.seed = 2;
        const Specimen other = mesh(request);
        EXPECT_NE(other.contact_strength_factor, fine.contact_strength_factor);
        EXPECT_EQ(other.node_position, fine.node_position);
    }
}

TEST(StrengthField, RefusesBadRequests) {
    Request good = rectangle_of(1122);
    good.fabric.strength = {5, 0.01, 3};
    compare_refusals(good, {{"a correlation without a modulus",
                             [](Request& r) {
                                 r.fabric.strength = {{}, 0.01, {}};
                             }},
                            {"a seed without a modulus", [](Request& r) {
                                 r.fabric.strength = {{}, {}, 3};
                             }}});
}

}  // namespace
}  // namespace graincrack::mesher
