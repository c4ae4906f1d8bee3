// Answers quickly, with a grid, how deep points lie inside a region and beside its prescribed edges.
#pragma once

#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// A grid over a region whose cells list the curves near them. The depth of a point is its distance from loops and prescribed
/// edges. A query costs O(curves near the cell); the construction compares each cell with each curve.
class DepthGrid {
public:
    /// \param reach largest depth of a query, m
    DepthGrid(const Region& region, double reach);

    /// True if a point lies inside, at least `depth` ≤ reach deep.
    [[nodiscard]] bool is_deep(Point p, double depth) const {
        const Cell* cell = cell_of(p);
        return cell != nullptr && (cell->deep || is_deep_in(*cell, p, depth));
    }
    /// Moves a point to a depth of at least `depth` ≤ reach; returns `before` if there is no room.
    [[nodiscard]] Point kept_deep(Point p, double depth, Point before) const {
        const Cell* cell = cell_of(p);
        return cell != nullptr && cell->deep ? p : moved_deep(p, depth, before);
    }

private:
    struct Cell {
        bool deep = false;        ///< entirely inside and beyond reach of all curves
        std::vector<Curve> near;  ///< if not deep: every curve that is nearest to some point of the cell
    };
    struct Nearest {
        const Curve* curve;
        double distance;
    };
    /// The cell of a point; null outside of the grid.
    [[nodiscard]] const Cell* cell_of(Point p) const {
        const double x = (p.x - low_.x) * inv_size_;
        const double y = (p.y - low_.y) * inv_size_;
        if (!(x >= 0 && y >= 0 && x < width_ && y < height_)) return nullptr;
        const int index = static_cast<int>(y) * n_x_ + static_cast<int>(x);
        return &cells_[index];
    }
    [[nodiscard]] static Nearest nearest(const Cell& cell, Point p);
    [[nodiscard]] bool is_deep_in(const Cell& cell, Point p, double depth) const;
    [[nodiscard]] Point moved_deep(Point p, double depth, Point before) const;

    const Region& region_;
    Point low_;
    double inv_size_;
    double width_ = 0;  ///< in cells
    double height_ = 0;
    int n_x_ = 0;
    std::vector<Cell> cells_;
    Cell all_;  ///< for points outside of the grid
};

}  // namespace graincrack::mesher
