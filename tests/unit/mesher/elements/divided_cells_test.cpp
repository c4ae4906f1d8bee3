#include "mesher/elements/divided_cells.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

#include <gtest/gtest.h>

#include <map>

namespace graincrack::mesher {
namespace {

TEST(DividedCells, SidesAreSharedAndFollowTheBoundary) {
    const PlaneMesh mesh = divided_cells(halves_of_square(), Bodies::cells, 0.3);
    EXPECT_EQ(mesh.n_bodies(), 2U);
    EXPECT_NEAR(mesh.area_of_body[0], 2, 1e-12);
    EXPECT_NEAR(mesh.area_of_body[1], 2, 1e-12);
    std::map<Edge, int> uses;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    }
    std::size_t n_outer = 0;
    for (const auto& [edge, n] : uses) {
        EXPECT_EQ(n, 1);
        if (!uses.contains({edge[1], edge[0]})) ++n_outer;
    }
    ASSERT_EQ(mesh.sides.size(), n_outer);
    double length_of_part[4] = {0, 0, 0, 0};
    for (std::size_t i = 0; i < n_outer; ++i) {
        const Side& side = mesh.sides[i];
        EXPECT_EQ(side.to, mesh.sides[(i + 1) % n_outer].from);
        length_of_part[side.part] += length(mesh.points[index(side.to)] - mesh.points[index(side.from)]);
    }
    for (const double each : length_of_part) EXPECT_NEAR(each, 2, 1e-12);
}

TEST(DividedCells, TrianglesCanBeBodies) {
    const PlaneMesh whole = divided_cells(halves_of_square(), Bodies::cells, 0.3);
    const PlaneMesh broken = divided_cells(halves_of_square(), Bodies::triangles, 0.3);
    EXPECT_EQ(broken.triangles, whole.triangles);
    EXPECT_EQ(broken.n_bodies(), broken.triangles.size());
    EXPECT_EQ(broken.crystal_of_body, whole.body_of_triangle);
    EXPECT_EQ(broken.body_points.size(), 3 * broken.triangles.size());
}

}  // namespace
}  // namespace graincrack::mesher
