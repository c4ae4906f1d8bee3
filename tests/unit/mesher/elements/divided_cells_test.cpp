#include "mesher/elements/divided_cells.hpp"

#include <gtest/gtest.h>

#include <map>

#include "share/base/error.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

TEST(DividedCells, ShareSidesAndFollowTheBoundary) {
    const PlaneMesh mesh = divided_cells(halves_of_square(), Bodies::cells, 0.3);
    EXPECT_EQ(mesh.n_bodies(), 2U);
    EXPECT_NEAR(mesh.area_of_body[0], 2, 1e-12);
    EXPECT_NEAR(mesh.area_of_body[1], 2, 1e-12);
    std::map<Edge, int> uses;
    for (const Triangle& t : mesh.triangles) count_sides(t, uses);
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
    const PlaneMesh broken = divided_cells(halves_of_square(), Bodies::triangles, 0.3);
    EXPECT_EQ(broken.triangles, mesh.triangles);
    EXPECT_EQ(broken.n_bodies(), broken.triangles.size());
    EXPECT_EQ(broken.crystal_of_body, mesh.body_of_triangle);
    EXPECT_EQ(broken.body_points.size(), 3 * broken.triangles.size());
}

PlaneCells two_triangles() {
    return cells_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 2, 0}, {2, 3, 0}},
                    {{0, 1, 0}, {1, 2, 1}, {2, 3, 2}, {3, 0, 3}, {0, 2, -1, ContactKind::pre_existing_crack}});
}

TEST(Lattice, SharesThePointsOfSides) {
    for (const int n : {1, 2, 5}) {
        const PlaneMesh mesh = lattice_mesh(two_triangles(), n);
        EXPECT_EQ(mesh.points.size(), static_cast<std::size_t>((n + 1) * (n + 1))) << n;
        EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(2 * n * n)) << n;
        ASSERT_EQ(mesh.n_bodies(), 2U);
        EXPECT_EQ(mesh.body_points[0], 0) << "a cell begins at its point of lowest index";
        EXPECT_EQ(mesh.area_of_body, (std::vector<double>{0.5, 0.5}));
        ASSERT_EQ(mesh.sides.size(), static_cast<std::size_t>(5 * n));
        for (int k = 0; k < n; ++k) {
            const Side& side = mesh.sides[static_cast<std::size_t>(4 * n + k)];
            EXPECT_EQ(side.kind, ContactKind::pre_existing_crack);
            const Point p = mesh.points[index(side.to)];
            EXPECT_NEAR(p.x, (k + 1.0) / n, 1e-15);
            EXPECT_EQ(p.x, p.y);
        }
    }
}

TEST(Lattice, RefusesMoreNodesThanIndices) { EXPECT_THROW(lattice_mesh(two_triangles(), 60000), UsageError); }

}  // namespace
}  // namespace graincrack::mesher
