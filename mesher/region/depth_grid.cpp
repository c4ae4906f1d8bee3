#include "mesher/region/depth_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

namespace graincrack::mesher {

namespace {

constexpr double cell_size = 2;  ///< size of a cell over the reach
constexpr int max_moves = 8;     ///< moves of a point between curves

}  // namespace

DepthGrid::DepthGrid(const Region& region, double reach)
    : region_(region),
      low_(bounds(region).low),
      inv_size_(1 / (cell_size * reach)),
      width_(std::floor(bounds(region).width() * inv_size_) + 1),
      height_(std::floor(bounds(region).height() * inv_size_) + 1),
      n_x_(static_cast<int>(width_)),
      cells_(static_cast<std::size_t>(width_ * height_)) {
    all_.near = curves_of(region);
    const double half_diagonal = 0.5 * std::numbers::sqrt2 / inv_size_;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const auto place = std::div(static_cast<long>(i), static_cast<long>(n_x_));
        const Point centre =
            low_ + (1 / inv_size_) * Point{static_cast<double>(place.rem) + 0.5, static_cast<double>(place.quot) + 0.5};
        Cell& cell = cells_[i];
        double least = std::numeric_limits<double>::infinity();
        for (const Curve& curve : all_.near) least = std::min(least, curve.distance(centre));
        cell.deep = least > (reach + half_diagonal) * (1 + 1e-9) && contains(region, centre);
        if (cell.deep) continue;
        // The curve nearest to a point of the cell is at most a diagonal farther from the centre than that nearest to the centre.
        for (const Curve& curve : all_.near) {
            if (curve.distance(centre) <= least + 2 * half_diagonal * (1 + 1e-9)) cell.near.push_back(curve);
        }
    }
}

DepthGrid::Nearest DepthGrid::nearest(const Cell& cell, Point p) {
    Nearest result{nullptr, std::numeric_limits<double>::infinity()};
    for (const Curve& curve : cell.near) {
        const double distance = curve.distance(p);
        if (distance < result.distance) result = {&curve, distance};
    }
    return result;
}

bool DepthGrid::is_deep_in(const Cell& cell, Point p, double depth) const {
    return nearest(cell, p).distance >= depth && contains(region_, p);
}

Point DepthGrid::moved_deep(Point p, double depth, Point before) const {
    for (int move = 0; move <= max_moves; ++move) {
        const Cell* cell = cell_of(p);
        if (cell != nullptr && cell->deep) return p;
        const Nearest near = nearest(cell != nullptr ? *cell : all_, p);
        const bool inside = contains(region_, p);
        if (inside && near.distance >= (move == 0 ? depth : depth * (1 - 1e-9))) return p;
        p = near.curve->moved_off(p, inside, depth);
    }
    return is_deep(p, depth / 2) ? p : before;
}

}  // namespace graincrack::mesher
