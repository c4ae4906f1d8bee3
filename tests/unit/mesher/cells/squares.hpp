// Squares as cells.
#pragma once

#include <algorithm>
#include <vector>

#include "mesher/cells/plane_cells.hpp"

namespace graincrack::mesher {

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
        cells.points.resize(4 + static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1));
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

}  // namespace graincrack::mesher
