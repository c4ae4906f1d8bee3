// What a test amounts to, from histories written by hand.
#include "solver/run/outcome.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/check.hpp"

namespace graincrack {
namespace {

using enum HistoryColumn;
using test::expect_close;

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

TEST(Outcome, StrengthIsThatOfTheSenseOfTheTest) {
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

TEST(Outcome, PlatenForcesAreComparedFromHalfThePeakToThePeak) {
    History h = rows_of_zeros(5);
    constexpr double width = 0.04;
    h[force_top] = {-0.1e6, -0.39e6, -0.9e6, -1e6, -0.5e6};
    h[force_bottom] = {-0.3e6, -0.41e6, -1.1e6, -1e6, -0.9e6};
    h[axial_stress] = {-0.2e6 / width, -0.4e6 / width, -1e6 / width, -1.1e6 / width, -0.7e6 / width};
    expect_close(platen_force_difference(header_of("uniaxial"), h, width), 0.2, 1e-12, 1);  // the row before the peak alone
}

TEST(Outcome, DampingLoadIsTheMeanOverTheLastTenthOfTheWayToThePeak) {
    History h = rows_of_zeros(5);
    h[axial_strain] = {0, -0.8e-3, -0.92e-3, -0.95e-3, -1e-3};
    h[axial_stress] = {0, -8e6, -9e6, -9.5e6, -10e6};
    h[damping_load] = {9, 9, 9, 0.01, 0.03};
    expect_close(damping_load_at_peak(header_of("uniaxial"), h), (3 * 0.01 + 5 * 0.03) / 8, 1e-12, 0.01);
    h[axial_stress] = {-10e6, 0, 0, 0, 0};  // no way to the peak
    EXPECT_EQ(damping_load_at_peak(header_of("uniaxial"), h), 0);
}

TEST(Outcome, DampingShareIsOfTheExternalWork) {
    History h = rows_of_zeros(2);
    EXPECT_EQ(damping_share(h), 0) << "without work";
    h[energy_external] = {0, 20};
    h[energy_damping] = {0, 5};
    EXPECT_EQ(damping_share(h), 0.25);
}

TEST(Outcome, ConfinementCountsFromTheEndOfTheIsotropicStage) {
    History h = rows_of_zeros(4);
    h[confining_pressure] = {0, 100, 3, 5};
    const Confinement achieved = achieved_confinement(h, 2);
    EXPECT_EQ(achieved.mean, 4);
    EXPECT_EQ(achieved.deviation, 1);
}

TEST(Outcome, CompletesTheHeader) {
    History h = rows_of_zeros(3);
    h[axial_stress] = {0, -5e6, -4e6};
    h[energy_external] = {0, 10, 20};
    h[energy_damping] = {0, 1, 4};
    h[confining_pressure] = {0, 2, 4};
    RunHeader header = header_of("triaxial");
    header.isotropic_end_time = 1;
    complete_header(h, 0.04, header);
    EXPECT_EQ(header.peak_axial_stress, 5e6);
    EXPECT_EQ(header.damping_share, 0.2);
    EXPECT_EQ(header.confinement_mean, 3);
    EXPECT_EQ(header.confinement_deviation, 1);
}

}  // namespace
}  // namespace graincrack
