#include "mesher/elements/divided_polygon.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "mesher/elements/placed_points.hpp"
#include "mesher/plane/constrained_triangulation.hpp"
#include "mesher/plane/step_length.hpp"

namespace graincrack::mesher {

namespace {

constexpr int triangulations = 3;
constexpr int smoothings = 4;         ///< after each triangulation
constexpr double first_reach = 0.12;  ///< of the moves that are tried, over the size; halved with each smoothing

/// Triangles of a polygon, whose inner points can move.
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

    /// Moves each point to the best of some places: the middle of its neighbours, and some around it.
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

    std::vector<Point> points_;  ///< of the boundary, then inner ones
    std::size_t n_fixed_;
    double good_;  ///< step length of an equilateral triangle
    std::vector<Edge> sides_;
    std::vector<Triangle> triangles_;
    std::vector<std::vector<std::size_t>> triangles_at_;  ///< of inner points
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
