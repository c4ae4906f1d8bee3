#include "mesher/seeds/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

namespace {

constexpr int tries_per_point = 16;

/// A grid whose cells are so small that points at the smallest distance lie in different cells.
class OccupancyGrid {
public:
    OccupancyGrid(const Box& box, double smallest, double largest, const std::vector<Point>& points)
        : points_(points),
          inv_cell_(std::sqrt(2.0) / smallest),
          margin_(cells_within(largest)),
          origin_(box.low),
          n_x_(static_cast<std::int64_t>(box.width() * inv_cell_) + 2 * margin_ + 1),
          n_y_(static_cast<std::int64_t>(box.height() * inv_cell_) + 2 * margin_ + 1),
          occupant_(static_cast<std::size_t>(n_x_ * n_y_), -1) {}

    /// True if a point keeps a distance from all others.
    [[nodiscard]] bool admits(Point p, double distance) const {
        const std::int64_t cell = cell_of(p);
        if (occupant_[static_cast<std::size_t>(cell)] >= 0) return false;
        const std::int64_t reach = cells_within(distance);
        for (std::int64_t row = cell - reach * n_x_; row <= cell + reach * n_x_; row += n_x_) {
            for (std::int64_t c = row - reach; c <= row + reach; ++c) {
                const std::int32_t q = occupant_[static_cast<std::size_t>(c)];
                if (q >= 0 && squared_length(points_[static_cast<std::size_t>(q)] - p) < distance * distance) return false;
            }
        }
        return true;
    }

    void insert(Point p, std::size_t index) {
        occupant_[static_cast<std::size_t>(cell_of(p))] = static_cast<std::int32_t>(index);
    }

private:
    [[nodiscard]] std::int64_t cells_within(double distance) const { return 1 + static_cast<std::int64_t>(distance * inv_cell_); }
    /// The cell of a point. A margin on all sides makes bounds checks in neighbour loops unnecessary.
    [[nodiscard]] std::int64_t cell_of(Point p) const {
        const auto x = static_cast<std::int64_t>((p.x - origin_.x) * inv_cell_) + margin_;
        const auto y = static_cast<std::int64_t>((p.y - origin_.y) * inv_cell_) + margin_;
        return y * n_x_ + x;
    }

    const std::vector<Point>& points_;
    double inv_cell_;
    std::int64_t margin_;
    Point origin_;
    std::int64_t n_x_, n_y_;
    std::vector<std::int32_t> occupant_;
};

/// A random vector with a length between r and 1.5 r, without trigonometry.
Point random_step(double r, RandomNumbers& random) {
    for (;;) {
        const Point p{1.5 * random.symmetric(), 1.5 * random.symmetric()};
        const double l2 = squared_length(p);
        if (l2 >= 1 && l2 <= 2.25) return r * p;
    }
}

/// Points on the bisectors of corners, a grain edge away from the corner and at least as far from each other.
/// \param edge of relative size 1, m
std::vector<Point> corner_points(const Region& region, double edge, const SizeField& size) {
    std::vector<Point> points;
    for (const Loop& loop : region.loops) {
        const std::size_t n = loop.corners.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Point at = loop.corners[i];
            const Point before = loop.behind((i + n - 1) % n);
            const Point after = loop.ahead(i);
            if (!can_be_cut_off(before, at, after)) continue;
            const Point middle = unit(after - at) + unit(before - at);
            points.push_back(at + edge * size.at(at) * (std::sqrt(1 / squared_length(middle)) * middle));
        }
    }
    const std::vector<Point> all = points;
    const auto has_neighbour = [&](Point p) {
        return std::any_of(all.begin(), all.end(), [&](Point q) { return q != p && length(q - p) < edge * size.at(p); });
    };
    points.erase(std::remove_if(points.begin(), points.end(), has_neighbour), points.end());
    return points;
}

}  // namespace

std::vector<Point> sample_points(const Region& region, const DepthGrid& depth, double min_distance, double margin,
                                 RandomNumbers& random, const SizeField& size) {
    const Box box = bounds(region);
    std::vector<Point> points;
    const double smallest = min_distance * size.smallest();
    OccupancyGrid grid(box, smallest, min_distance * size.largest(), points);
    std::vector<std::size_t> active;
    const auto accept = [&](Point p) {
        grid.insert(p, points.size());
        active.push_back(points.size());
        points.push_back(p);
    };
    const auto admits = [&](Point p) {
        const double local = size.at(p);
        return depth.is_deep(p, margin * local) && grid.admits(p, min_distance * local);
    };
    const auto grow = [&] {
        while (!active.empty()) {
            const std::size_t place = random.below(active.size());
            const Point from = points[active[place]];
            bool placed = false;
            for (int i = 0; i < tries_per_point && !placed; ++i) {
                const Point p = from + random_step(min_distance * size.at(from), random);
                placed = admits(p);
                if (placed) accept(p);
            }
            if (!placed) {
                active[place] = active.back();
                active.pop_back();
            }
        }
    };
    for (const Point p : corner_points(region, 1.3 * min_distance, size)) {
        if (admits(p)) accept(p);
    }
    const Point centre = midpoint(box.low, box.high);
    for (int i = 0; i < 1000 && points.empty(); ++i) {
        const Point p = centre + Point{0.5 * box.width() * random.symmetric(), 0.5 * box.height() * random.symmetric()};
        if (depth.is_deep(p, margin * size.at(p))) accept(p);
    }
    grow();
    // Holes, necks, prescribed edges and steps of size may keep the growth from some parts, so points are tried all over the
    // region.
    if (!is_plain(region) || size.varies()) {
        for (double y = box.low.y; y < box.high.y; y += smallest / 2) {
            for (double x = box.low.x; x < box.high.x; x += smallest / 2) {
                const Point p{x + smallest / 2 * random.uniform(), y + smallest / 2 * random.uniform()};
                if (!admits(p)) continue;
                accept(p);
                grow();
            }
        }
    }
    const auto order = hilbert_order(points);
    std::vector<Point> sorted(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = points[static_cast<std::size_t>(order[i])];
    return sorted;
}

}  // namespace graincrack::mesher
