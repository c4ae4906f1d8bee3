#include "mesher/cells/cut_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "mesher/cells/polygon.hpp"
#include "mesher/region/shapes.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"

namespace graincrack::mesher {
namespace {

/// Length of sides along prescribed edges, all of which have cells on both sides.
double length_of_flaws(const CutCells& cut) {
    double sum = 0;
    for (const Side& side : cut.cells.sides) {
        if (side.part >= 0) continue;
        const Edge edge = edge_between(side.from, side.to);
        EXPECT_TRUE(std::binary_search(cut.cells.edges.begin(), cut.cells.edges.end(), edge));
        sum += length(cut.cells.points[index(side.to)] - cut.cells.points[index(side.from)]);
    }
    return sum;
}

/// Cells of area 1 that fill a rectangle of 8 x 6.
const RandomCells& tiles() {
    static const RandomCells cells(rectangle(8, 6), 48, 0, SizeDistribution::normal, 1);
    return cells;
}

Point middle_of(const PlaneCells& cells, std::size_t cell) { return moments(corners_of(cells, cell)).centroid; }

/// They cut along walls, and where they have no room.
std::optional<CutCells> cut(const Walls& walls, Point& no_room) {
    const Zones zones(walls);
    std::vector<std::size_t> zone_of_cell;
    for (std::size_t cell = 0; cell < 48; ++cell) zone_of_cell.push_back(zones.zone_at(middle_of(tiles().made.cells, cell)));
    return cut_cells(tiles().made.cells, tiles().requested, walls, zones, zone_of_cell, {}, no_room);
}
CutCells cut(const Walls& walls) {
    Point no_room;
    return cut(walls, no_room).value();
}

void expect_whole(const CutCells& cut, std::size_t n, double area) {
    ASSERT_EQ(cut.cells.size(), n);
    const std::vector<double> areas = areas_of(cut.cells);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), area, 1e-12 * area);
    EXPECT_NEAR(std::accumulate(cut.areas.begin(), cut.areas.end(), 0.0), area, 1e-12 * area);
    EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0);
}

TEST(CutCells, FollowASlitThatCrossesThem) {
    Region region = rectangle(8, 6);
    region.edges = {central_slit(region, 4, 0.4, "slit")};
    const CutCells made = cut(walls_of(region, 1));
    expect_whole(made, 48, 48);
    EXPECT_NEAR(length_of_flaws(made), 4, 1e-12);
}

TEST(CutCells, KeepTheirNumberOnEitherSideOfAJoint) {
    Region region = rectangle(8, 6);
    region.edges = {{{-5, 0.25}, {5, 0.25}, {ContactKind::grain_boundary, "joint"}}};
    const CutCells made = cut(walls_of(region, 1));
    expect_whole(made, 48, 48);
    EXPECT_NEAR(length_of_flaws(made), 8, 1e-12);
    const auto is_above = [&](std::size_t cell) { return middle_of(made.cells, cell).y > 0.25; };
    int above = 0;
    for (std::size_t cell = 0; cell < 48; ++cell) above += is_above(cell) ? 1 : 0;
    for (std::size_t cell = 0; cell < 48; ++cell) {
        EXPECT_NEAR(made.areas[cell], is_above(cell) ? 8 * 2.75 / above : 8 * 3.25 / (48 - above), 1e-12);
    }
}

// A joint that cuts a corner off leaves there a zone in which no seed lies.
TEST(CutCells, SayWhereTheyHaveNoRoom) {
    Region region = rectangle(8, 6);
    region.edges = {{{3.6, -3}, {4, -2.6}, {ContactKind::grain_boundary, "joint"}}};
    Point no_room;
    EXPECT_FALSE(cut(walls_of(region, 1), no_room));
    EXPECT_NEAR(no_room.x, 3.8, 0.2);
    EXPECT_NEAR(no_room.y, -2.8, 0.2);
}

TEST(CutCells, EndAtTheWallOfAHole) {
    Region region = rectangle(8, 6);
    add_hole(region, {0.3, 0.2}, 1.2, "--hole");
    const Walls walls = walls_of(region, 0.5);
    const CutCells made = cut(walls);
    // Cells in the hole are gone.
    std::size_t inside = 0;
    for (std::size_t cell = 0; cell < 48; ++cell) inside += walls.contains(middle_of(tiles().made.cells, cell)) ? 1 : 0;
    EXPECT_LT(inside, 48U);
    expect_whole(made, inside, area(region));
    double rim = 0;
    for (const Side& side : made.cells.sides) {
        if (side.part != 5) continue;
        rim += length(made.cells.points[index(side.to)] - made.cells.points[index(side.from)]);
    }
    EXPECT_NEAR(rim, 2 * 3.14159 * 1.2, 0.15);
}

}  // namespace
}  // namespace graincrack::mesher
