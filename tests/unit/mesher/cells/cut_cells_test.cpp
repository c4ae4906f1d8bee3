#include "mesher/cells/cut_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "mesher/cells/polygon.hpp"
#include "mesher/region/shapes.hpp"

namespace graincrack::mesher {
namespace {

/// Squares of side 1 that fill a rectangle of even width and height around the origin.
struct Squares {
    PlaneCells cells;
    std::vector<Point> seeds;
    std::vector<double> areas;

    Squares(int width, int height) {
        const auto point = [&](int i, int j) {  // corners first
            const bool is_corner = (i == 0 || i == width) && (j == 0 || j == height);
            if (is_corner) return j == 0 ? (i == 0 ? 0 : 1) : (i == 0 ? 3 : 2);
            return 4 + i + j * (width + 1);
        };
        cells.points.resize(static_cast<std::size_t>(4 + (width + 1) * (height + 1)));
        for (int j = 0; j <= height; ++j) {
            for (int i = 0; i <= width; ++i) {
                cells.points[static_cast<std::size_t>(point(i, j))] = {i - width / 2.0, j - height / 2.0};
            }
        }
        for (int j = 0; j < height; ++j) {
            for (int i = 0; i < width; ++i) {
                const std::vector<int> loop{point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)};
                cells.corners.insert(cells.corners.end(), loop.begin(), loop.end());
                cells.start.push_back(static_cast<int>(cells.corners.size()));
                for (std::size_t k = 0; k < 4; ++k) cells.edges.push_back(edge_between(loop[k], loop[(k + 1) % 4]));
                seeds.push_back({i + 0.5 - width / 2.0, j + 0.5 - height / 2.0});
            }
        }
        std::sort(cells.edges.begin(), cells.edges.end());
        cells.edges.erase(std::unique(cells.edges.begin(), cells.edges.end()), cells.edges.end());
        for (int i = 0; i < width; ++i) cells.sides.push_back({point(i, 0), point(i + 1, 0), 0, {}});
        for (int j = 0; j < height; ++j) cells.sides.push_back({point(width, j), point(width, j + 1), 1, {}});
        for (int i = width; i > 0; --i) cells.sides.push_back({point(i, height), point(i - 1, height), 2, {}});
        for (int j = height; j > 0; --j) cells.sides.push_back({point(0, j), point(0, j - 1), 3, {}});
        areas.assign(seeds.size(), 1);
    }
};

/// Length of sides along prescribed edges, all of which have cells on both sides.
double length_of_flaws(const CutCells& cut) {
    double sum = 0;
    for (const Side& side : cut.cells.sides) {
        if (side.part >= 0) continue;
        const Edge edge = edge_between(side.from, side.to);
        EXPECT_TRUE(std::binary_search(cut.cells.edges.begin(), cut.cells.edges.end(), edge));
        sum +=
            length(cut.cells.points[static_cast<std::size_t>(side.to)] - cut.cells.points[static_cast<std::size_t>(side.from)]);
    }
    return sum;
}

void expect_whole(const CutCells& cut, std::size_t n, double area) {
    ASSERT_EQ(cut.cells.size(), n);
    const std::vector<double> areas = areas_of(cut.cells);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), area, 1e-12 * area);
    EXPECT_NEAR(std::accumulate(cut.areas.begin(), cut.areas.end(), 0.0), area, 1e-12 * area);
    EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0);
}

TEST(CutCells, FollowASlitThatCrossesThem) {
    const Squares squares(8, 6);
    Region region = rectangle(8, 6);
    region.edges = {central_slit(region, 4, 0.4, "slit")};
    const auto cut = cut_cells(squares.cells, squares.seeds, squares.areas, walls_of(region, 1));
    ASSERT_TRUE(cut);
    expect_whole(*cut, 48, 48);
    EXPECT_NEAR(length_of_flaws(*cut), 4, 1e-12);
}

TEST(CutCells, OnEitherSideOfAJointKeepTheirNumberAndFillTheirSide) {
    const Squares squares(8, 6);
    Region region = rectangle(8, 6);
    region.edges = {{{-5, 0.25}, {5, 0.25}, {ContactKind::grain_boundary, "joint"}}};
    const auto cut = cut_cells(squares.cells, squares.seeds, squares.areas, walls_of(region, 1));
    ASSERT_TRUE(cut);
    expect_whole(*cut, 48, 48);
    EXPECT_NEAR(length_of_flaws(*cut), 8, 1e-12);
    // 24 below on 8 x 3.25, 24 above on 8 x 2.75
    for (std::size_t cell = 0; cell < 48; ++cell) {
        double middle = 0;
        for (const int p : cut->cells.loop(cell)) middle += cut->cells.points[static_cast<std::size_t>(p)].y;
        const bool is_above = middle / static_cast<double>(cut->cells.loop(cell).size()) > 0.25;
        EXPECT_NEAR(cut->areas[cell], (is_above ? 2.75 : 3.25) / 3, 1e-12);
    }
}

TEST(CutCells, EndAtTheWallOfAHole) {
    const Squares squares(8, 6);
    Region region = rectangle(8, 6);
    add_hole(region, {0.3, 0.2}, 1.2, "--hole");
    std::vector<double> areas = squares.areas;
    const Walls walls = walls_of(region, 0.5);
    const auto cut = cut_cells(squares.cells, squares.seeds, areas, walls);
    ASSERT_TRUE(cut);
    // Seeds in the hole have no cells.
    const auto inside = std::count_if(squares.seeds.begin(), squares.seeds.end(), [&](Point p) { return walls.contains(p); });
    EXPECT_LT(inside, 48);
    expect_whole(*cut, static_cast<std::size_t>(inside), area(region));
    double rim = 0;
    for (const Side& side : cut->cells.sides) {
        if (side.part != 5) continue;
        rim +=
            length(cut->cells.points[static_cast<std::size_t>(side.to)] - cut->cells.points[static_cast<std::size_t>(side.from)]);
    }
    EXPECT_NEAR(rim, 2 * 3.14159 * 1.2, 0.15);
}

}  // namespace
}  // namespace graincrack::mesher
