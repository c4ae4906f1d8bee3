#include "mesher/elements/divided_cells.hpp"

#include <gtest/gtest.h>

namespace graincrack::mesher {
namespace {

/// A square of side 2 in a left and a right half.
PlaneCells two_halves() {
    PlaneCells cells;
    cells.points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}};
    cells.corners = {0, 4, 5, 3, 4, 1, 2, 5};
    cells.start = {0, 4, 8};
    cells.edges = {{0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 5}, {3, 5}, {4, 5}};
    cells.sides = {{0, 4, 0, {}}, {4, 1, 0, {}}, {1, 2, 1, {}}, {2, 5, 2, {}}, {5, 3, 2, {}}, {3, 0, 3, {}}};
    return cells;
}

TEST(DividedCells, TrianglesFillTheirCellsAndNoneIsFlat) {
    const RefinedMesh mesh = divided_cells(two_halves(), 0.3);
    ASSERT_EQ(mesh.triangles.size(), mesh.region_of_triangle.size());
    double area[2] = {0, 0};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(mesh.triangles[t][k % 3])]; };
        const double twice = cross(at(1) - at(0), at(2) - at(0));
        area[mesh.region_of_triangle[t]] += twice / 2;
        // The altitude of an equilateral triangle of this side is 0.26.
        for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(twice / length(at(k + 1) - at(k)), 0.26 / 3);
    }
    EXPECT_NEAR(area[0], 2, 1e-12);
    EXPECT_NEAR(area[1], 2, 1e-12);
}

}  // namespace
}  // namespace graincrack::mesher
