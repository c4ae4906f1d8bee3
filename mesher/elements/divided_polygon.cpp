#include "mesher/elements/divided_polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "mesher/plane/step_length.hpp"
#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

namespace {

constexpr double least_distance = 0.72;     ///< distance of a new point from others, over the element size; chosen by trial
constexpr double farthest = 1.5;            ///< distance over the size beyond which places are equivalent
constexpr int n_levels = 32;                ///< levels of distance
constexpr double places_per_size = 5;       ///< grid places along an element; chosen by trial
constexpr double points_over_sides = 1.15;  ///< weight of a distance from a side against one from a point; chosen by trial

/// Places on a grid over a polygon, each with its distance from boundary and points.
class FreePlaces {
public:
    FreePlaces(std::span<const Point> boundary, double size) : size_(size), spacing_(size / places_per_size) {
        const Box box = box_of(boundary);
        // A polygon has several places across, as many below its middle as above it.
        spacing_ = std::min(spacing_, std::min(box.width(), box.height()) / places_per_size);
        columns_ = static_cast<int>(std::ceil(box.width() / spacing_));
        rows_ = static_cast<int>(std::ceil(box.height() / spacing_));
        low_ = 0.5 * (box.low + box.high - Point{columns_ * spacing_, rows_ * spacing_});
        distance_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
        mark_inside(boundary);
        for (std::size_t i = 0; i < boundary.size(); ++i) keep_from_side(boundary[i], boundary[(i + 1) % boundary.size()]);
        for (std::size_t i = 0; i < distance_.size(); ++i) offer(i);
        for (std::vector<std::size_t>& level : levels_) {
            for (std::size_t i = level.size(); i > 1; --i) std::swap(level[i - 1], level[scattered(i) % i]);
        }
    }

    /// Takes a place that is approximately the farthest. \return false if there is none
    bool take(Point& place) {
        while (!levels_.empty()) {
            std::vector<std::size_t>& highest = levels_.back();
            if (highest.empty()) {
                levels_.pop_back();
                continue;
            }
            const std::size_t index = highest.back();
            highest.pop_back();
            if (level_of(distance_[index]) + 1 < static_cast<int>(levels_.size())) {
                offer(index);
                continue;
            }
            place = at(index);
            keep_from(place, place, 1);
            return true;
        }
        return false;
    }

private:
    /// A hash from 0 to 2³² − 1 without patterns along rows or columns.
    static std::uint32_t scattered(std::size_t index) {
        std::uint64_t x = (index + 1) * 0x9e3779b97f4a7c15U;
        x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
        return static_cast<std::uint32_t>((x ^ (x >> 27U)) >> 16U);
    }

    /// The place is random in its square of the grid, so that elements have no preferred direction.
    [[nodiscard]] Point at(std::size_t index) const {
        const std::size_t row = index / static_cast<std::size_t>(columns_);
        const std::size_t column = index % static_cast<std::size_t>(columns_);
        const std::uint32_t bits = scattered(index);
        return low_ + spacing_ * Point{static_cast<double>(column) + (bits & 0xffffU) / 65536.0,
                                       static_cast<double>(row) + (bits >> 16U) / 65536.0};
    }

    /// Level of a place by its distance; negative if no point may be there.
    [[nodiscard]] int level_of(double distance) const {
        return static_cast<int>(std::floor(n_levels * (distance / size_ - least_distance) / (farthest - least_distance)));
    }

    void offer(std::size_t index) {
        const int level = std::min(level_of(distance_[index]), n_levels - 1);
        if (level >= 0) levels_[static_cast<std::size_t>(level)].push_back(index);
    }

    /// Sets the largest distance at places inside: those between an odd and an even crossing of their row with the boundary.
    void mark_inside(std::span<const Point> boundary) {
        std::vector<std::vector<double>> crossings(static_cast<std::size_t>(rows_));
        const auto row_above = [&](double y) {
            return std::clamp(static_cast<int>(std::ceil((y - low_.y) / spacing_ - 0.5)), 0, rows_);
        };
        for (std::size_t i = 0; i < boundary.size(); ++i) {
            const Point p = boundary[i];
            const Point q = boundary[(i + 1) % boundary.size()];
            const int end = row_above(std::max(p.y, q.y));
            for (int row = row_above(std::min(p.y, q.y)); row < end; ++row) {
                const double y = low_.y + (row + 0.5) * spacing_;
                crossings[static_cast<std::size_t>(row)].push_back(p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x));
            }
        }
        for (std::size_t row = 0; row < crossings.size(); ++row) {
            std::vector<double>& x = crossings[row];
            std::sort(x.begin(), x.end());
            for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
                const int first = std::max(0, static_cast<int>(std::ceil((x[i] - low_.x) / spacing_ - 0.5)));
                const int end = std::min(columns_, static_cast<int>(std::ceil((x[i + 1] - low_.x) / spacing_ - 0.5)));
                for (int column = first; column < end; ++column) {
                    distance_[row * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)] = farthest * size_;
                }
            }
        }
    }

    void keep_from_side(Point from, Point to) {
        keep_from(from, from, 1);
        keep_from(from, to, points_over_sides);
    }

    /// Limits the distances of places near a segment to their distance from it times a factor.
    void keep_from(Point from, Point to, double factor) {
        const double reach = farthest * size_ / factor;
        const auto index_at = [&](double x, int n) { return std::clamp(static_cast<int>(std::floor(x / spacing_)), 0, n - 1); };
        const int left = index_at(std::min(from.x, to.x) - reach - low_.x, columns_);
        const int right = index_at(std::max(from.x, to.x) + reach - low_.x, columns_);
        const int bottom = index_at(std::min(from.y, to.y) - reach - low_.y, rows_);
        const int top = index_at(std::max(from.y, to.y) + reach - low_.y, rows_);
        const Point along = to - from;
        const double squared = squared_length(along);
        for (int row = bottom; row <= top; ++row) {
            for (int column = left; column <= right; ++column) {
                const std::size_t index =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
                double& distance = distance_[index];
                if (distance <= 0) continue;
                const Point p = at(index);
                const double share = squared > 0 ? std::clamp(dot(p - from, along) / squared, 0.0, 1.0) : 0;
                distance = std::min(distance, factor * length(p - from - share * along));
            }
        }
    }

    double size_, spacing_;
    Point low_;
    int columns_ = 0, rows_ = 0;
    std::vector<double> distance_;                            ///< negative outside
    std::vector<std::vector<std::size_t>> levels_{n_levels};  ///< [level] places that had such a distance
};

}  // namespace

std::vector<Point> placed_points(std::span<const Point> boundary, double size) {
    FreePlaces free(boundary, size);
    std::vector<Point> points;
    for (Point place; free.take(place);) points.push_back(place);
    if (points.size() < 2) return points;
    std::vector<Point> sorted;
    for (const int i : hilbert_order(points)) sorted.push_back(points[static_cast<std::size_t>(i)]);
    return sorted;
}

namespace {

constexpr int triangulations = 3;
constexpr int smoothings = 4;         ///< smoothings after each triangulation
constexpr double first_reach = 0.12;  ///< reach of the tried moves, over the size; halved in each smoothing; by trial

/// The triangles of a polygon with movable inner points.
class MovablePoints {
public:
    MovablePoints(std::span<const Point> boundary, std::vector<Point> inner, double size)
        : points_(boundary.begin(), boundary.end()), n_fixed_(boundary.size()), good_(step_length_over_side * size) {
        const int n = static_cast<int>(n_fixed_);
        for (int i = 0; i < n; ++i) sides_.push_back({i, (i + 1) % n});
        points_.insert(points_.end(), inner.begin(), inner.end());
    }

    void triangulate() {
        triangles_ = constrained_triangles(points_, sides_);
        triangles_at_.assign(points_.size() - n_fixed_, {});
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            for (const int p : triangles_[t]) {
                if (index(p) >= n_fixed_) triangles_at_[index(p) - n_fixed_].push_back(t);
            }
        }
    }

    /// Moves each point to the best of several places: the middle of its neighbours, and places around it.
    void smooth(double reach) {
        for (std::size_t p = n_fixed_; p < points_.size(); ++p) {
            const Point before = points_[p];
            Point sum;
            for (const std::size_t t : triangles_at_[p - n_fixed_]) {
                for (const int q : triangles_[t]) sum = sum + points_[index(q)];
            }
            const auto n = static_cast<double>(triangles_at_[p - n_fixed_].size());
            const Point middle = (1 / (2 * n)) * (sum - n * before);
            const std::array<Point, 5> places{middle, before + Point{reach, 0}, before - Point{reach, 0},
                                              before + Point{0, reach}, before - Point{0, reach}};
            Point best = before;
            double least = cost_at(p);
            for (const Point place : places) {
                points_[p] = place;
                const double cost = cost_at(p);
                if (cost < least) {
                    least = cost;
                    best = place;
                }
            }
            points_[p] = best;
        }
    }

    DividedPolygon finish() {
        return {{points_.begin() + static_cast<std::ptrdiff_t>(n_fixed_), points_.end()}, std::move(triangles_)};
    }

private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] double step_length_of(const Triangle& t) const {
        return step_length(points_[index(t[0])], points_[index(t[1])], points_[index(t[2])]);
    }
    [[nodiscard]] double cost_at(std::size_t p) const {
        double sum = 0;
        for (const std::size_t t : triangles_at_[p - n_fixed_]) sum += step_cost(step_length_of(triangles_[t]) / good_);
        return sum;
    }

    std::vector<Point> points_;  ///< points of the boundary, then inner points
    std::size_t n_fixed_;
    double good_;  ///< step length of an equilateral triangle
    std::vector<Edge> sides_;
    std::vector<Triangle> triangles_;
    std::vector<std::vector<std::size_t>> triangles_at_;  ///< triangles at inner points
};

MovablePoints smoothed(std::span<const Point> boundary, std::vector<Point> inner, double size) {
    MovablePoints movable(boundary, std::move(inner), size);
    for (int i = 0; i < triangulations; ++i) {
        movable.triangulate();
        double reach = first_reach * size;
        for (int k = 0; k < smoothings; ++k, reach /= 2) movable.smooth(reach);
    }
    return movable;
}

}  // namespace

DividedPolygon divided_polygon(std::span<const Point> boundary, double size) {
    std::vector<Point> inner = placed_points(boundary, size);
    return smoothed(boundary, std::move(inner), size).finish();
}

}  // namespace graincrack::mesher
