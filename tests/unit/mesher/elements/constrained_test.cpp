#include "mesher/elements/constrained.hpp"

#include <gtest/gtest.h>

namespace graincrack::mesher {
namespace {

TEST(ConstrainedMesh, FillsACellThatIsNotConvex) {
    PlaneCells cells;
    cells.points = {{9, 9}, {0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    cells.corners = {1, 2, 3, 4, 5, 6};
    cells.start = {0, 6};
    const PlaneMesh whole = constrained_mesh(cells, Bodies::cells);
    EXPECT_EQ(whole.triangles.size(), 4U);
    EXPECT_EQ(whole.body_of_triangle, (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(whole.body_points, cells.corners);
    EXPECT_EQ(whole.area_of_body, std::vector<double>{3});
    const PlaneMesh broken = constrained_mesh(cells, Bodies::triangles);
    EXPECT_EQ(broken.triangles, whole.triangles);
    EXPECT_EQ(broken.body_of_triangle, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(broken.crystal_of_body, (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(broken.body_start, (std::vector<int>{0, 3, 6, 9, 12}));
}

}  // namespace
}  // namespace graincrack::mesher
