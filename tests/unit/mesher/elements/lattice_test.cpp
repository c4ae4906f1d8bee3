#include "mesher/elements/divided_cells.hpp"

#include <gtest/gtest.h>

#include "share/base/error.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

PlaneCells two_cells() {
    return cells_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 2, 0}, {2, 3, 0}},
                    {{0, 1, 0}, {1, 2, 1}, {2, 3, 2}, {3, 0, 3}, {0, 2, -1, ContactKind::pre_existing_crack}});
}

TEST(Lattice, SharesThePointsOfSides) {
    for (const int n : {1, 2, 5}) {
        const PlaneMesh mesh = lattice_mesh(two_cells(), n);
        EXPECT_EQ(mesh.points.size(), static_cast<std::size_t>((n + 1) * (n + 1))) << n;
        EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(2 * n * n)) << n;
        ASSERT_EQ(mesh.n_bodies(), 2U);
        EXPECT_EQ(mesh.body_points[0], 0) << "a cell begins at its point of lowest index";
        ASSERT_EQ(mesh.sides.size(), static_cast<std::size_t>(5 * n));
        double area = 0;
        for (const Triangle& t : mesh.triangles) {
            const auto at = [&](std::size_t k) { return mesh.points[index(t[k])]; };
            area += signed_area(at(0), at(1), at(2));
        }
        EXPECT_NEAR(area, 1, 1e-14);
        EXPECT_EQ(mesh.area_of_body, (std::vector<double>{0.5, 0.5}));
        for (int k = 0; k < n; ++k) {
            const Side& side = mesh.sides[static_cast<std::size_t>(4 * n + k)];
            EXPECT_EQ(side.kind, ContactKind::pre_existing_crack);
            const Point p = mesh.points[index(side.to)];
            EXPECT_NEAR(p.x, (k + 1.0) / n, 1e-15);
            EXPECT_EQ(p.x, p.y);
        }
    }
}

TEST(Lattice, RefusesMoreNodesThanIndices) { EXPECT_THROW(lattice_mesh(two_cells(), 60000), UsageError); }

}  // namespace
}  // namespace graincrack::mesher
