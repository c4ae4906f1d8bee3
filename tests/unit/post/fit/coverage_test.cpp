// Every printed 95 % interval covers what was planted in 93.5 to 96.5 % of 2,000 synthetic sets: 95 % with three standard errors
// of 0.5 %. The numbers are the same in every run.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <string>

#include "post/ccd/design.hpp"
#include "post/ccd/solve.hpp"
#include "post/cracks/emission.hpp"
#include "post/fit/envelope.hpp"
#include "post/fit/size_effect.hpp"
#include "tests/support/normal.hpp"

namespace graincrack {
namespace {

using test::Normal;

constexpr int sets = 2000;
constexpr double degrees = 180 / std::numbers::pi;

/// Counts, for each named interval, how often it holds what was planted.
class Coverage {
public:
    void add(const std::string& name, bool holds) { held_[name] += holds ? 1 : 0; }
    void add(const std::string& name, const Estimate& e, double planted) {
        ASSERT_TRUE(e.low && e.high) << name;
        add(name, *e.low <= planted && planted <= *e.high);
    }
    void expect_95_percent() const {
        EXPECT_FALSE(held_.empty());
        for (const auto& [name, held] : held_) {
            EXPECT_GE(held, 0.935 * sets) << name;
            EXPECT_LE(held, 0.965 * sets) << name;
        }
    }

private:
    std::map<std::string, int> held_;
};

/// Draws the sets. \param add one set
void expect_coverage(std::uint32_t stream, const std::function<void(Normal&, Coverage&)>& add) {
    Normal normal(stream);
    Coverage coverage;
    for (int i = 0; i < sets; ++i) add(normal, coverage);
    coverage.expect_95_percent();
}

// Augig granite: what the laboratory gives, as planted values.
constexpr double true_cohesion = 21e6;
constexpr double friction_angle = 53 / degrees;
constexpr double sigma_ci = 122e6;
constexpr double mi = 14;  // σt of 8.7 MPa

double mohr_coulomb(double c, double phi, double confining) {
    const double b = (1 + std::sin(phi)) / (1 - std::sin(phi));
    return 2 * c * std::sqrt(b) + b * confining;
}
double hoek_brown(double ci, double m, double confining) { return confining + ci * std::sqrt(m * confining / ci + 1); }

TEST(Coverage, Is95PercentForEnvelopesOverAllRuns) {
    const std::vector<double> confining{0, 0, 0, 4e6, 4e6, 4e6, 8e6, 8e6, 8e6};
    expect_coverage(20140402, [&](Normal& normal, Coverage& coverage) {
        std::vector<double> line, curve;
        for (const double s : confining) {
            const double noise = 3e6 * normal();
            line.push_back(mohr_coulomb(true_cohesion, friction_angle, s) + noise);
            curve.push_back(hoek_brown(sigma_ci, mi, s) + noise);
        }
        const Envelope envelope = fit_envelope(confining, line);
        coverage.add("C", envelope.cohesion, true_cohesion);
        coverage.add("phi", envelope.friction_angle, friction_angle);
        const auto fit = fit_hoek_brown(confining, curve);
        ASSERT_TRUE(fit.has_value());
        coverage.add("sigma_ci", fit->sigma_ci, sigma_ci);
        coverage.add("mi", fit->mi, mi);
    });
}

TEST(Coverage, Is95PercentForEnvelopesOverSeeds) {
    expect_coverage(20140404, [&](Normal& normal, Coverage& coverage) {
        EnvelopeTests lines;
        for (std::int64_t seed = 1; seed <= 5; ++seed) {  // each seed is a rock of its own
            const double c = true_cohesion + 0.85e6 * normal();
            const double phi = friction_angle + 1.5 / degrees * normal();
            for (const double s : {0.0, 4e6, 8e6}) lines.compression.push_back({s, mohr_coulomb(c, phi, s), seed});
        }
        const auto line = fit_seed_envelopes(lines);
        coverage.add("C", line->cohesion.mean, true_cohesion);
        coverage.add("phi", line->friction_angle.mean, friction_angle);
    });
}

TEST(Coverage, Is95PercentForPowerLawsOfSize) {
    expect_coverage(20140439, [&](Normal& normal, Coverage& coverage) {
        std::vector<double> edge, relative;
        for (const double e : {2e-3, 3e-3, 5e-3, 7.5e-3}) {
            for (int seed = 0; seed < 3; ++seed) {
                edge.push_back(e);
                relative.push_back(5e6 * std::pow(e * 1e3, 0.39) * std::exp(0.06 * normal()));
            }
        }
        coverage.add("exponent by logarithms", fit_power_law(edge, relative)->exponent, 0.39);
    });
}

TEST(Coverage, Is95PercentForLinearModels) {
    const auto runs = ccd::coded_runs(2, ccd::Star::rotatable, 5);
    const std::vector<double> planted{11, 7, -5, -7, 1, 7};  // as Eq 19: 1, x1, x2, x1 x2, x1², x2²
    const auto terms = quadratic_terms(2);
    const auto truth = [&](const std::vector<double>& x) {
        double sum = 0;
        for (std::size_t i = 0; i < terms.size(); ++i) sum += planted[i] * terms[i](x);
        return sum;
    };
    const std::vector<double> place{0.44, -0.53};
    expect_coverage(20140435, [&](Normal& normal, Coverage& coverage) {
        std::vector<double> response;
        for (const auto& x : runs) response.push_back(truth(x) + 2 * normal());
        const LinearModel model = ccd::fit_quadratic(runs, response);
        for (std::size_t i = 0; i < terms.size(); ++i) {
            const double error = model.standard_error(i);
            const double coefficient = model.coefficients(static_cast<Eigen::Index>(i));
            coverage.add(terms[i].name(), estimate(coefficient, error * error, model.freedom), planted[i]);
        }
        coverage.add("mean", model.confidence(place), truth(place));
        coverage.add("single run", model.prediction(place), truth(place) + 2 * normal());
    });
}

TEST(Coverage, Is95PercentForTheJointRegionOfFactors) {
    const auto runs = ccd::coded_runs(2, ccd::Star::rotatable, 5);
    const std::vector<double> place{0.4, -0.5};
    const auto first = [](const std::vector<double>& x) { return 11 + 7 * x[0] - 5 * x[1] - 7 * x[0] * x[1]; };
    const auto second = [](const std::vector<double>& x) { return 67 - 5 * x[0] + 16 * x[1] - 8 * x[1] * x[1]; };
    expect_coverage(20140435, [&](Normal& normal, Coverage& coverage) {
        std::vector<double> a, b;
        for (const auto& x : runs) {
            const double common = normal();  // residuals of the two are correlated, as those of C and φ are
            a.push_back(first(x) + 2 * common);
            b.push_back(second(x) - 3 * common + 1.5 * normal());
        }
        const std::vector<LinearModel> models{ccd::fit_quadratic(runs, a), ccd::fit_quadratic(runs, b)};
        coverage.add("region", ccd::ConfidenceRegion(models, {first(place), second(place)}).holds(place));
    });
}

TEST(Coverage, Is95PercentForGutenbergRichter) {
    constexpr double planted = 1.2;
    double mean = 0;
    expect_coverage(20140441, [&](Normal& normal, Coverage& coverage) {
        std::vector<double> magnitudes;
        for (int i = 0; i < 300; ++i) magnitudes.push_back(-5 - std::log10(normal.uniform()) / planted);
        const auto fit = fit_gutenberg_richter(magnitudes, -5);
        ASSERT_TRUE(fit.has_value());
        mean += fit->b / sets;
        coverage.add("b", std::abs(fit->b - planted) <= 1.959964 * fit->error);  // the normal's 97.5 % point
    });
    EXPECT_NEAR(mean, planted, 0.02);  // standard error 0.0015, bias b/n = 0.004
}

}  // namespace
}  // namespace graincrack
