#include "mesher/point_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mesher/triangulation.hpp"

namespace graincrack::mesher {

namespace {

constexpr int tries_per_point = 16;

/// Grid of cells so small that points at the minimum distance lie in different cells.
class OccupancyGrid {
public:
    OccupancyGrid(const Shape& shape, double min_distance, const std::vector<Point>& points)
        : points_(points),
          min_squared_(min_distance * min_distance),
          inv_cell_(std::sqrt(2.0) / min_distance),
          origin_{-shape.width / 2, -shape.height / 2},
          n_x_(static_cast<std::int64_t>(shape.width * inv_cell_) + 5),
          n_y_(static_cast<std::int64_t>(shape.height * inv_cell_) + 5),
          occupant_(static_cast<std::size_t>(n_x_ * n_y_), -1) {}

    /// Whether a point keeps its distance from all others.
    [[nodiscard]] bool admits(Point p) const {
        const std::int64_t cell = cell_of(p);
        if (occupant_[static_cast<std::size_t>(cell)] >= 0) return false;
        for (std::int64_t row = cell - 2 * n_x_; row <= cell + 2 * n_x_; row += n_x_) {
            for (std::int64_t c = row - 2; c <= row + 2; ++c) {
                const std::int32_t q = occupant_[static_cast<std::size_t>(c)];
                if (q >= 0 && squared_length(points_[static_cast<std::size_t>(q)] - p) < min_squared_) return false;
            }
        }
        return true;
    }

    void insert(Point p, std::size_t index) {
        occupant_[static_cast<std::size_t>(cell_of(p))] = static_cast<std::int32_t>(index);
    }

private:
    /// A margin of two cells on all sides makes bounds checks in the neighbour loops unnecessary.
    [[nodiscard]] std::int64_t cell_of(Point p) const {
        const auto x = static_cast<std::int64_t>((p.x - origin_.x) * inv_cell_) + 2;
        const auto y = static_cast<std::int64_t>((p.y - origin_.y) * inv_cell_) + 2;
        return y * n_x_ + x;
    }

    const std::vector<Point>& points_;
    double min_squared_;
    double inv_cell_;
    Point origin_;
    std::int64_t n_x_;
    std::int64_t n_y_;
    std::vector<std::int32_t> occupant_;
};

/// Random direction times a length between r and 1.5 r, without trigonometry.
Point random_step(double r, RandomNumbers& random) {
    for (;;) {
        const Point p{1.5 * random.symmetric(), 1.5 * random.symmetric()};
        const double l2 = squared_length(p);
        if (l2 >= 1 && l2 <= 2.25) return r * p;
    }
}

/// Points on the bisectors of a rectangle's corners, as far from the corner as a grain edge is long.
std::vector<Point> corner_points(const Shape& shape, double distance) {
    if (shape.kind != ShapeKind::rectangle) return {};
    const double x = shape.width / 2 - distance * std::sqrt(0.5);
    const double y = shape.height / 2 - distance * std::sqrt(0.5);
    if (2 * std::min(x, y) < distance) return {};
    return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

}  // namespace

std::vector<Point> sample_points(const Shape& shape, double min_distance, double margin, RandomNumbers& random) {
    std::vector<Point> points;
    OccupancyGrid grid(shape, min_distance, points);
    std::vector<std::size_t> active;
    const auto accept = [&](Point p) {
        grid.insert(p, points.size());
        active.push_back(points.size());
        points.push_back(p);
    };
    for (const Point p : corner_points(shape, 1.3 * min_distance)) accept(p);
    for (int i = 0; i < 1000 && points.empty(); ++i) {
        const Point p{0.5 * shape.width * random.symmetric(), 0.5 * shape.height * random.symmetric()};
        if (depth_inside(shape, p) >= margin) accept(p);
    }
    while (!active.empty()) {
        const std::size_t place = random.below(active.size());
        const Point from = points[active[place]];
        bool placed = false;
        for (int i = 0; i < tries_per_point && !placed; ++i) {
            const Point p = from + random_step(min_distance, random);
            placed = depth_inside(shape, p) >= margin && grid.admits(p);
            if (placed) accept(p);
        }
        if (!placed) {
            active[place] = active.back();
            active.pop_back();
        }
    }
    const auto order = hilbert_order(points);
    std::vector<Point> sorted(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = points[static_cast<std::size_t>(order[i])];
    return sorted;
}

}  // namespace graincrack::mesher
