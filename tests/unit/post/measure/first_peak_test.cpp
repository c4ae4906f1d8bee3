#include "post/measure/strength.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

using Points = std::vector<std::pair<double, double>>;

/// A test from straight pieces through points of strain (%) and stress (MPa), a row every 0.0005 % strain. Contacts fail from
/// `cracks_from` (%) on.
struct MadeTest {
    MadeTest(const Points& points, double cracks_from = 0.1) {
        for (std::size_t piece = 0; piece + 1 < points.size(); ++piece) {
            const auto [from, low] = points[piece];
            const auto [to, high] = points[piece + 1];
            const int rows = static_cast<int>(std::round((to - from) / 0.0005));
            for (int i = piece == 0 ? 0 : 1; i <= rows; ++i) {
                strain.push_back(1e-2 * (from + (to - from) * i / rows));
                stress.push_back(1e6 * (low + (high - low) * i / rows));
                failed.push_back(strain.back() > 1e-2 * cracks_from ? 1 : 0);
            }
        }
    }
    [[nodiscard]] std::optional<FirstPeak> first_peak(double confining_pressure = 0) const {
        const CurveColumns curve{strain, stress, failed};
        const auto peak = find_first_peak(curve, confining_pressure);
        return peak ? std::optional(with_residual(*peak, curve, confining_pressure)) : std::nullopt;
    }
    std::vector<double> strain, stress, failed;
};

TEST(FirstPeak, HasAResidualStrengthAndRehardening) {
    // Peak of 108 MPa at 0.4 %, a fall to 58 at 0.45 %, from there 5 GPa.
    const MadeTest test({{0, 8}, {0.4, 108}, {0.45, 58}, {1.5, 110.5}});
    const auto peak = test.first_peak(8e6);
    ASSERT_TRUE(peak.has_value());
    EXPECT_NEAR(peak->strain, 0.004, smoothing_strain);
    EXPECT_NEAR(peak->stress, 108e6, 1e6);
    EXPECT_LT(peak->stress, 108e6);  // smoothed
    const double beyond_fall = peak->strain + 0.004 - 0.0045;
    ASSERT_TRUE(peak->residual.has_value());
    EXPECT_NEAR(*peak->residual, 58e6 + 5e9 * beyond_fall, 1);
    EXPECT_NEAR(*peak->drop, (peak->stress - *peak->residual) / (peak->stress - 8e6), 1e-12);
    ASSERT_TRUE(peak->rehardening.has_value());
    EXPECT_NEAR(*peak->rehardening, 5e9, 1);
}

TEST(FirstPeak, NeedsAFallOfMoreThanFivePerCentOfTheDeviator) {
    for (const Points& points : {Points{{0, 0}, {0.4, 100}, {1.5, 180}}, Points{{0, 0}, {0.4, 100}, {1.5, 100}},
                                 Points{{0, 0}, {0.4, 100}, {0.45, 96}, {1.5, 180}}}) {
        EXPECT_FALSE(MadeTest(points).first_peak().has_value());
    }
    const auto six = MadeTest({{0, 0}, {0.4, 100}, {0.45, 94}, {1.5, 180}}).first_peak();
    ASSERT_TRUE(six.has_value());
    EXPECT_NEAR(six->strain, 0.004, smoothing_strain);
    EXPECT_LT(*six->drop, 0);  // the stress has risen beyond the first peak
    // From 100 to 95.5 MPa: 4.5 % of σ1, 5.6 % of σ1 − σ3.
    const MadeTest test({{0, 20}, {0.4, 100}, {0.45, 95.5}, {0.6, 95.5}, {1.5, 180}});
    EXPECT_FALSE(test.first_peak().has_value());
    EXPECT_TRUE(test.first_peak(20e6).has_value());
}

// Of two; two dips that add up to a fall where the maximum before was never exceeded; a fall within a tenth of the window, which
// ends the test.
TEST(FirstPeak, IsTheFirstMaximumThatTheStressHasFallenFrom) {
    for (const Points& points :
         {Points{{0, 0}, {0.4, 100}, {0.45, 80}, {0.9, 140}, {0.95, 60}, {1.5, 60}},
          Points{{0, 0}, {0.4, 100}, {0.45, 96}, {0.5, 98}, {0.55, 94}, {1.5, 94}}, Points{{0, 0}, {0.4, 100}, {0.4005, 70}}}) {
        const auto peak = MadeTest(points).first_peak();
        ASSERT_TRUE(peak.has_value());
        EXPECT_NEAR(peak->strain, 0.004, smoothing_strain);
        EXPECT_NEAR(peak->stress, 100e6, 1e6);
    }
}

TEST(FirstPeak, IgnoresNoiseNarrowerThanTheWindow) {
    MadeTest test({{0, 0}, {0.4, 100}, {1.5, 180}});
    // Spikes of ten per cent that last a fifth of the window, either way: the mean moves by two per cent.
    for (std::size_t row = 500; row + 600 < test.stress.size(); row += 300) {
        test.stress[row] *= 0.8;
        test.stress[row + 150] *= 1.2;
    }
    EXPECT_FALSE(test.first_peak().has_value());
    // As wide as the window they are falls.
    for (std::size_t row = 1500; row < 1512; ++row) test.stress[row] *= 0.8;
    EXPECT_TRUE(test.first_peak().has_value());
}

TEST(FirstPeak, IgnoresFallsBeforeAnyContactHasFailed) {
    const Points points{{0, 0}, {0.05, 10}, {0.08, 5}, {0.4, 100}, {1.5, 180}};
    EXPECT_FALSE(MadeTest(points).first_peak().has_value());
    EXPECT_TRUE(MadeTest(points, 0.01).first_peak().has_value());
}

TEST(FirstPeak, HasNoResidualStrengthIfTheTestEndsTooEarly) {
    // The window of the residual strength ends at 0.9 %.
    const auto peak = MadeTest({{0, 0}, {0.4, 100}, {0.45, 60}, {0.88, 60}}).first_peak();
    ASSERT_TRUE(peak.has_value());
    EXPECT_FALSE(peak->residual.has_value());
    EXPECT_FALSE(peak->drop.has_value());
    EXPECT_FALSE(peak->rehardening.has_value());
    const auto longer = MadeTest({{0, 0}, {0.4, 100}, {0.45, 60}, {0.92, 60}}).first_peak();
    EXPECT_NEAR(*longer->residual, 60e6, 1);
    EXPECT_NEAR(*longer->drop, 1 - 60e6 / longer->stress, 1e-9);
    EXPECT_FALSE(longer->rehardening.has_value());
}

TEST(FirstPeak, HasRehardeningOfTheStrainThatWasReached) {
    const auto part = MadeTest({{0, 0}, {0.4, 100}, {0.45, 60}, {0.85, 60}, {1.1, 70}}).first_peak();
    ASSERT_TRUE(part->rehardening.has_value());  // from 0.9 to 1.1 %
    EXPECT_NEAR(*part->rehardening, 4e9, 1);
    const auto falls = MadeTest({{0, 0}, {0.4, 100}, {0.45, 60}, {1.5, 39}}).first_peak();
    EXPECT_NEAR(*falls->rehardening, -2e9, 1);
}

TEST(FirstPeak, IsThatOfTheAxialLoadingOfARun) {
    const test::Recipe recipe{.test = "triaxial", .confining_pressure = 8e6};
    RunData run{"run.h5", test::synthetic_header(recipe), test::synthetic_history(recipe), {0.08, 0.16, 7, 256, 0.005}};
    const auto peak = measure_first_peak(run, load_curve(run));
    ASSERT_TRUE(peak.has_value());
    EXPECT_NEAR(peak->stress, 125e6, 2e6);
    run.header.test = "tension";
    EXPECT_FALSE(measure_first_peak(run, LoadCurve{}).has_value());
}

}  // namespace
}  // namespace graincrack
