// Polygons: cells that fill a region, with their edges and sides, and convex outlines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesher/seeds/seeds.hpp"

namespace graincrack::mesher {

/// A convex polygon, counter-clockwise.
struct ConvexOutline {
    std::vector<Point> corners;
    std::vector<std::uint8_t> parts;  ///< [corners] boundary part of the side from each corner to the next

    [[nodiscard]] std::size_t size() const { return corners.size(); }
    [[nodiscard]] Point corner(std::size_t i) const { return corners[i < size() ? i : i - size()]; }
};

struct PlaneCells {
    std::vector<Point> points;
    std::vector<int> corners;   ///< points of all cells, cell by cell counter-clockwise
    std::vector<int> start{0};  ///< [cells + 1] first corner of each cell
    std::vector<Edge> edges;    ///< edges of all cells, ascending
    std::vector<Side> sides;    ///< sides of the boundary, the region on their left, loop by loop; then along prescribed edges

    [[nodiscard]] std::size_t size() const { return start.size() - 1; }
    [[nodiscard]] std::span<const int> loop(std::size_t cell) const {
        return {corners.data() + start[cell], corners.data() + start[cell + 1]};
    }
};

}  // namespace graincrack::mesher
