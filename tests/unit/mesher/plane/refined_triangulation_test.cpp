#include "mesher/plane/refined_triangulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "share/base/error.hpp"
#include "tests/support/golden.hpp"

namespace graincrack::mesher {
namespace {

/// A square of 10 with a square of 2 inside it, region 0 and 1.
const std::vector<Point> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {4, 4}, {6, 4}, {6, 6}, {4, 6}};
const std::vector<RegionEdge> borders{{0, 1, 0, -1}, {1, 2, 0, -1}, {2, 3, 0, -1}, {0, 3, -1, 0},
                                      {4, 5, 1, 0},  {5, 6, 1, 0},  {6, 7, 1, 0},  {4, 7, 0, 1}};

TEST(RefinedTriangles, FillRegionsWithinBounds) {
    const RefinedMesh mesh = refined_triangles(square, borders, {1});
    ASSERT_EQ(mesh.triangles.size(), mesh.region_of_triangle.size());
    for (std::size_t i = 0; i < square.size(); ++i) EXPECT_EQ(mesh.points[i], square[i]);
    double area[2] = {};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const auto at = [&](std::size_t k) { return mesh.points[index(t[k % 3])]; };
        const double own = signed_area(at(0), at(1), at(2));
        EXPECT_GT(own, 0);
        area[mesh.region_of_triangle[i]] += own;
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LE(length(at(k + 1) - at(k)), 1.5);
            const double angle =
                std::atan2(cross(at(k + 1) - at(k), at(k + 2) - at(k)), dot(at(k + 1) - at(k), at(k + 2) - at(k)));
            EXPECT_GE(angle * 180 / std::numbers::pi, 20);
        }
    }
    EXPECT_NEAR(area[0], 96, 1e-12);
    EXPECT_NEAR(area[1], 4, 1e-12);
}

TEST(RefinedTriangles, AreTheSameEachTime) {
    const auto mesh = [] { return refined_triangles(square, borders, {0.2}); };
    EXPECT_EQ(mesh().points, mesh().points);
    EXPECT_EQ(mesh().triangles, mesh().triangles);
    EXPECT_EQ(mesh().region_of_triangle, mesh().region_of_triangle);
}

TEST(RefinedTriangles, RefuseBordersThatCrossAndTooManyPoints) {
    test::Refusals refused;
    const auto add = [&](const std::string& what, Point corner) {
        std::vector<Point> points = square;
        points[6] = corner;
        refused.add<UsageError>(what, [&] { refined_triangles(points, borders, {1}); });
    };
    add("a corner across a border", {12, 6});
    add("a corner on a border", {10, 6});
    add("two points at one place", square[5]);
    refused.add<UsageError>("more points than allowed", [] { (void)refined_triangles(square, borders, {0.06, 20, 1000}); });
    test::expect_golden(refused.text());
}

}  // namespace
}  // namespace graincrack::mesher
