#include "mesher/elements/placed_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>

namespace graincrack::mesher {

namespace {

constexpr double least_distance = 0.72;  ///< of a new point from the others, over the size of elements
constexpr double farthest = 1.5;         ///< distance over the size from which on places are alike
constexpr double places_per_size = 5;
constexpr double points_over_sides = 1.15;  ///< a distance from a side counts as so much of one from a point

/// Places on a grid over a polygon, each with its distance from what is there.
class FreePlaces {
public:
    FreePlaces(std::span<const Point> boundary, double size) : size_(size), spacing_(size / places_per_size) {
        Point high = low_ = boundary[0];
        for (const Point p : boundary) {
            low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        // At least some places across a polygon, and as many below its middle as above it.
        spacing_ = std::min(spacing_, std::min(high.x - low_.x, high.y - low_.y) / places_per_size);
        columns_ = static_cast<int>(std::ceil((high.x - low_.x) / spacing_));
        rows_ = static_cast<int>(std::ceil((high.y - low_.y) / spacing_));
        low_ = 0.5 * (low_ + high - Point{columns_ * spacing_, rows_ * spacing_});
        distance_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
        mark_inside(boundary);
        for (std::size_t i = 0; i < boundary.size(); ++i) keep_from_side(boundary[i], boundary[(i + 1) % boundary.size()]);
        for (std::size_t i = 0; i < distance_.size(); ++i) offer(i);
    }

    /// Takes the place that is farthest from everything. \return whether there is one
    bool take(Point& place) {
        while (!places_.empty()) {
            const Place best = places_.top();
            places_.pop();
            if (best.distance > distance_[best.index]) {
                offer(best.index);
                continue;
            }
            place = at(best.index);
            keep_from(place, place, 1);
            return true;
        }
        return false;
    }

private:
    struct Place {
        double distance;
        std::uint32_t order;  ///< of places that are as far as others: scattered
        std::size_t index;
        friend bool operator<(const Place& a, const Place& b) {
            return a.distance != b.distance ? a.distance < b.distance : a.order < b.order;
        }
    };

    [[nodiscard]] Point at(std::size_t index) const {
        const auto row = static_cast<double>(index / static_cast<std::size_t>(columns_));
        const auto column = static_cast<double>(index % static_cast<std::size_t>(columns_));
        return low_ + spacing_ * Point{column + 0.5, row + 0.5};
    }

    void offer(std::size_t index) {
        if (!(distance_[index] >= least_distance * size_)) return;
        places_.push({distance_[index], static_cast<std::uint32_t>(index) * 2654435761U, index});
    }

    /// Gives places inside the largest distance: those between an odd and an even crossing of their row with the boundary.
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

    /// Lowers the distances of places near a segment to the distance from it times a factor.
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
                double& distance =
                    distance_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
                if (distance <= 0) continue;
                const Point p = low_ + spacing_ * Point{column + 0.5, row + 0.5};
                const double share = squared > 0 ? std::clamp(dot(p - from, along) / squared, 0.0, 1.0) : 0;
                distance = std::min(distance, factor * length(p - from - share * along));
            }
        }
    }

    double size_;
    double spacing_;
    Point low_;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<double> distance_;  ///< negative outside
    std::priority_queue<Place> places_;
};

}  // namespace

std::vector<Point> placed_points(std::span<const Point> boundary, double size) {
    FreePlaces free(boundary, size);
    std::vector<Point> points;
    for (Point place; free.take(place);) points.push_back(place);
    return points;
}

}  // namespace graincrack::mesher
