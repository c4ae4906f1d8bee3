#include "mesher/region/region.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/region/shapes.hpp"

namespace graincrack::mesher {
namespace {

TEST(StretchedRegion, KeepsAreasAndReturns) {
    const Stretch stretch({3, 0.5});
    const Point axis{std::cos(0.5), std::sin(0.5)};
    EXPECT_NEAR(length(stretch.elongated(axis)), std::sqrt(3), 1e-14);
    EXPECT_NEAR(length(stretch.elongated(left_of(axis))), 1 / std::sqrt(3), 1e-14);
    EXPECT_NEAR(length(stretch.elongated(stretch.equiaxed({1, 2})) - Point{1, 2}), 0, 1e-14);
    const Point exact = Stretch({1, 0.7}).equiaxed({0.1, 0.3});
    EXPECT_EQ(exact, (Point{0.1, 0.3}));
    EXPECT_NEAR(area(stretched(rectangle(2, 3), stretch, 0.1)) / 6, 1, 1e-14);
    for (const Region& region : {disc(2), ring(2, 1), half_disc(2), disc_with_flats(2, 0.4)}) {
        const Region image = stretched(region, stretch, 0.02);
        EXPECT_NEAR(area(image) / area(region), 1, 1e-3) << region.name;  // sides of 0.02 on radii of 1 and 0.5
    }
    EXPECT_TRUE(is_round(stretched(disc(2), {}, 0.1))) << "as it is without elongation";
}

}  // namespace
}  // namespace graincrack::mesher
