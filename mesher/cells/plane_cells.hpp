// Cells: polygons that fill a region, and what is known about their sides.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/seeds/seeds.hpp"

namespace graincrack::mesher {

struct PlaneCells {
    std::vector<Point> points;
    std::vector<int> corners;   ///< points of all cells, each counter-clockwise
    std::vector<int> start{0};  ///< [cells + 1] first corner of each cell
    std::vector<Edge> edges;    ///< of all cells, ascending
    std::vector<Side> sides;    ///< of the boundary, with the region on their left, loop by loop; then along prescribed edges

    [[nodiscard]] std::size_t size() const { return start.size() - 1; }
    [[nodiscard]] std::span<const int> loop(std::size_t cell) const {
        return {corners.data() + start[cell], corners.data() + start[cell + 1]};
    }
};

}  // namespace graincrack::mesher
