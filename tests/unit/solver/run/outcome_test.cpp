// What a test amounts to, from histories written by hand.
#include "solver/run/outcome.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/golden.hpp"

namespace graincrack::test {
namespace {

using enum HistoryColumn;

constexpr double sample_width = 0.04;

/// Rows of which all columns are zero, but the time: 0, 1, 2, … s.
History rows_of_zeros(std::size_t rows) {
    History h;
    for (auto& column : h.columns) column.assign(rows, 0);
    for (std::size_t i = 0; i < rows; ++i) h[time][i] = static_cast<double>(i);
    return h;
}

RunHeader header_of(const std::string& test) {
    RunHeader header;
    header.test = test;
    return header;
}
RunHeader completed(const std::string& test, const History& h, double isotropic_end_time = 0) {
    RunHeader header = header_of(test);
    header.isotropic_end_time = isotropic_end_time;
    complete_header(h, sample_width, header);
    return header;
}

TEST(Outcome, HasTheStrengthInTheSenseOfTheTest) {
    History h = rows_of_zeros(4);
    h[axial_stress] = {0, -5e6, 2e6, -3e6};
    EXPECT_EQ(sign_of_strength(header_of("uniaxial"), h), -1);
    EXPECT_EQ(peak_row(header_of("uniaxial"), h), 1U);
    EXPECT_EQ(sign_of_strength(header_of("tension"), h), 1);
    EXPECT_EQ(peak_row(header_of("tension"), h), 2U);
    EXPECT_EQ(sign_of_strength(header_of("program"), h), -1) << "it presses more than it pulls";
    h[axial_stress][2] = 6e6;
    EXPECT_EQ(peak_row(header_of("program"), h), 2U);
}

// While a test runs and at its end: 2F/(πtD) of a disc, the load of bending.
TEST(Outcome, PrintsTheLoadAsTheQuantityOfTheTest) {
    expect_golden(load_text(header_of("brazilian"), 12.61e6, sample_width) + "\n" +
                  load_text(header_of("uniaxial"), 12.61e6, sample_width) + "\n" +
                  load_text(header_of("bend"), 0.25e6, sample_width));
}

// The stress falls by a fifth behind the third row, and exceeds it at the end. What is said of the test's quality is of the
// strength too.
TEST(Outcome, HasTheTimeAndTheQualityOfItsStrength) {
    History h = rows_of_zeros(5);
    h[axial_strain] = {0, -0.0039, -0.004, -0.006, -0.01};
    h[axial_stress] = {0, -50e6, -100e6, -80e6, -120e6};
    h[tensile_cracks] = {0, 0, 1, 2, 3};
    h[damping_load] = {0, 0, 0.03, 0.5, 0.5};
    h[force_top] = {0, -2.02e6, -4.12e6, -5e6, -5e6};
    h[force_bottom] = {0, -1.98e6, -3.88e6, -1e6, -1e6};
    EXPECT_EQ(completed("uniaxial", h).peak_time, 2);
    expect_close(completed("uniaxial", h).damping_load, 0.03, 1e-12, 0.03);
    EXPECT_EQ(completed("uniaxial", h).platen_force_difference, 0);  // the only row before it has half of its stress
    EXPECT_EQ(completed("uniaxial", h).peak_axial_stress, 120e6);
    h[tensile_cracks] = {0, 0, 0, 0, 0};
    EXPECT_EQ(completed("uniaxial", h).peak_time, 4) << "it did not fail";
}

TEST(Outcome, ComparesPlatenForcesFromHalfThePeakToThePeak) {
    History h = rows_of_zeros(5);
    h[force_top] = {-0.1e6, -0.39e6, -0.9e6, -1e6, -0.5e6};
    h[force_bottom] = {-0.3e6, -0.41e6, -1.1e6, -1e6, -0.9e6};
    h[axial_stress] = {-0.2e6 / sample_width, -0.4e6 / sample_width, -1e6 / sample_width, -1.1e6 / sample_width,
                       -0.7e6 / sample_width};
    expect_close(completed("uniaxial", h).platen_force_difference, 0.2, 1e-12, 1);  // the row before the peak alone
}

TEST(Outcome, HasTheMeanDampingLoadOfTheLastTenthBeforeThePeak) {
    History h = rows_of_zeros(5);
    h[axial_strain] = {0, -0.8e-3, -0.92e-3, -0.95e-3, -1e-3};
    h[axial_stress] = {0, -8e6, -9e6, -9.5e6, -10e6};
    h[damping_load] = {9, 9, 9, 0.01, 0.03};
    expect_close(completed("uniaxial", h).damping_load, (3 * 0.01 + 5 * 0.03) / 8, 1e-12, 0.01);
    h[axial_stress] = {-10e6, 0, 0, 0, 0};  // no way to the peak
    EXPECT_EQ(completed("uniaxial", h).damping_load, 0);
}

TEST(Outcome, CountsConfinementFromTheEndOfTheIsotropicStage) {
    History h = rows_of_zeros(4);
    EXPECT_EQ(completed("triaxial", h).damping_share, 0) << "without work";
    h[axial_stress] = {0, -5e6, -4e6, 0};
    h[energy_external] = {0, 10, 20, 20};
    h[energy_damping] = {0, 1, 4, 5};
    h[confining_pressure] = {0, 100, 3, 5};
    const RunHeader header = completed("triaxial", h, 2);
    EXPECT_EQ(header.peak_axial_stress, 5e6);
    EXPECT_EQ(header.damping_share, 0.25);
    EXPECT_EQ(header.confinement_mean, 4);
    EXPECT_EQ(header.confinement_deviation, 1);
}

}  // namespace
}  // namespace graincrack::test
