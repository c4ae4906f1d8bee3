// How deep points lie inside a region, also below its prescribed edges: answers of a grid, fast for many points.
#pragma once

#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// A grid over a region whose cells know the curves near them. The depth of a point is its distance from loops and prescribed
/// edges.
class DepthGrid {
public:
    /// \param reach largest depth that is asked for, m
    DepthGrid(const Region& region, double reach);

    /// Whether a point lies inside, at least `depth` ≤ reach deep.
    [[nodiscard]] bool is_deep(Point p, double depth) const {
        const Cell* cell = cell_of(p);
        return cell != nullptr && (cell->deep || is_deep_in(*cell, p, depth));
    }
    /// A point moved to at least `depth` ≤ reach where it is not as deep; `before` where there is no room for that.
    [[nodiscard]] Point kept_deep(Point p, double depth, Point before) const {
        const Cell* cell = cell_of(p);
        return cell != nullptr && cell->deep ? p : moved_deep(p, depth, before);
    }

private:
    struct Cell {
        bool deep = false;        ///< wholly inside and beyond reach of all curves
        std::vector<Curve> near;  ///< of a cell that is not deep: all curves that are the nearest to some point of it
    };
    struct Nearest {
        const Curve* curve;
        double distance;
    };
    /// The cell of a point; null outside of the grid, and of the region.
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
