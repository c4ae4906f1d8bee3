// Makes cells from lists of points, and cells that are squares.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "mesher/cells/plane_cells.hpp"

namespace graincrack::mesher {

/// Cells with counter-clockwise loops of points.
inline PlaneCells cells_of(std::vector<Point> points, const std::vector<std::vector<int>>& loops, std::vector<Side> sides = {}) {
    PlaneCells cells;
    cells.points = std::move(points);
    for (const auto& loop : loops) {
        cells.corners.insert(cells.corners.end(), loop.begin(), loop.end());
        cells.start.push_back(static_cast<int>(cells.corners.size()));
        for (std::size_t i = 0; i < loop.size(); ++i) cells.edges.push_back(edge_between(loop[i], loop[(i + 1) % loop.size()]));
    }
    std::sort(cells.edges.begin(), cells.edges.end());
    cells.edges.erase(std::unique(cells.edges.begin(), cells.edges.end()), cells.edges.end());
    cells.sides = std::move(sides);
    return cells;
}

/// A square of side 2, divided into a left and a right half.
inline PlaneCells halves_of_square() {
    return cells_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}}, {{0, 4, 5, 3}, {4, 1, 2, 5}},
                    {{0, 4, 0, {}}, {4, 1, 0, {}}, {1, 2, 1, {}}, {2, 5, 2, {}}, {5, 3, 2, {}}, {3, 0, 3, {}}});
}

/// Squares of side 1 that fill a rectangle of even width and height around the origin.
struct Squares {
    PlaneCells cells;
    std::vector<Point> seeds;
    std::vector<double> areas;

    Squares(int width, int height) {
        const int row = width + 1;
        const std::vector<int> corners{0, width, row * (height + 1) - 1, row * height};
        std::vector<int> order = corners;  // points in rows from below, after the corners
        for (int k = 0; k < row * (height + 1); ++k) {
            if (std::find(corners.begin(), corners.end(), k) == corners.end()) order.push_back(k);
        }
        std::vector<int> number(order.size());
        for (std::size_t k = 0; k < order.size(); ++k) {
            number[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
            cells.points.push_back({order[k] % row - width / 2.0, order[k] / row - height / 2.0});
        }
        const auto point = [&](int i, int j) { return number[static_cast<std::size_t>(i + j * row)]; };
        std::vector<std::vector<int>> loops;
        for (int j = 0; j < height; ++j) {
            for (int i = 0; i < width; ++i) {
                loops.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
                seeds.push_back({i + 0.5 - width / 2.0, j + 0.5 - height / 2.0});
            }
        }
        cells = cells_of(std::move(cells.points), loops);
        for (int i = 0; i < width; ++i) cells.sides.push_back({point(i, 0), point(i + 1, 0), 0, {}});
        for (int j = 0; j < height; ++j) cells.sides.push_back({point(width, j), point(width, j + 1), 1, {}});
        for (int i = width; i > 0; --i) cells.sides.push_back({point(i, height), point(i - 1, height), 2, {}});
        for (int j = height; j > 0; --j) cells.sides.push_back({point(0, j), point(0, j - 1), 3, {}});
        areas.assign(seeds.size(), 1);
    }
};

}  // namespace graincrack::mesher
