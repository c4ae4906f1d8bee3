#include "post/cracks/rosette.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Rosette, LinesHaveNoHead) {
    EXPECT_EQ(rosette_bin(0), 0U);
    EXPECT_EQ(rosette_bin(pi), 0U);
    EXPECT_EQ(rosette_bin(-pi), 0U);
    EXPECT_EQ(rosette_bin(pi / 4), rosette_bin(pi / 4 - pi));
    EXPECT_EQ(rosette_bin(pi / 2), 9U);
    EXPECT_EQ(rosette_bin(pi - 0.01), 17U);
}

TEST(Rosette, GridHasThreeDirections) {
    const Rosette rosette = crack_rosette({}, test::grid_specimen(4, 4, 0.04, 0.04));
    EXPECT_NEAR(rosette.facet[0], 3 * 0.04, 1e-12);
    EXPECT_NEAR(rosette.facet[9], 3 * 0.04, 1e-12);
    EXPECT_NEAR(rosette.facet[4], 16 * std::sqrt(2) * 0.01, 1e-12);  // 45°
    double sum = 0;
    for (double length : rosette.facet) sum += length;
    EXPECT_NEAR(sum, 6 * 0.04 + 16 * std::sqrt(2) * 0.01, 1e-12);
}

TEST(Rosette, CracksGoByModeAndLength) {
    Crack crack;
    crack.orientation = 25 * pi / 180;
    crack.length = 0.002;
    std::vector<Crack> cracks(3, crack);
    cracks[2].mode = CrackMode::shear;
    const Rosette rosette = crack_rosette(cracks, test::grid_specimen(1, 1, 0.01, 0.01));
    EXPECT_NEAR(rosette.tensile[2], 0.004, 1e-15);
    EXPECT_NEAR(rosette.shear[2], 0.002, 1e-15);
}

TEST(Rosette, AlongTheLoadIsWithin30Degrees) {
    std::array<double, Rosette::n_bins> length{};
    EXPECT_EQ(share_along_load(length), std::nullopt);
    for (std::size_t bin = 0; bin < length.size(); ++bin) length[bin] = bin >= 6 && bin < 12 ? 3 : 1;  // 60° to 120° from x
    EXPECT_DOUBLE_EQ(share_along_load(length).value(), 18.0 / 30);
    length.fill(0);
    length[5] = length[12] = 1;
    EXPECT_EQ(share_along_load(length), 0.0);
}

TEST(Rosette, SharesAreEmptyWithoutCracks) {
    std::ostringstream out;
    write_rosette(out, crack_rosette({}, test::grid_specimen(4, 4, 0.04, 0.04)), TableFormat::tsv);
    EXPECT_EQ(test::parse_tsv(out.str()).size(), 19U);
    EXPECT_EQ(test::field(out.str(), "tensile_share"), "");
    EXPECT_NE(test::field(out.str(), "facet_share"), "");
}

}  // namespace
}  // namespace graincrack
