#include "mesher/import/label_smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace graincrack::mesher {

namespace {

/// Width of the low-pass (its standard deviation along the chain) over the spacing of points, and its bounds in pixels: below,
/// steps of pixels would stay; above, they are gone and only curvature would be lost.
constexpr double width_over_spacing = 1.0 / 3;
constexpr double least_width = 1;
constexpr double most_width = 4;
/// Squared distance of the middles of neighbouring sides of pixels, on the average of directions.
constexpr double squared_step = 0.75;
constexpr std::size_t least_points_closed = 6;

/// The corners of pixels, in place of the first and last the nodes of what is not closed.
std::vector<Point> corners(const BoundaryChain& chain, Point from, Point to) {
    std::vector<Point> points = chain.path;
    if (chain.closed()) return points;
    points.front() = from;
    points.back() = to;
    return points;
}

/// The middles of the sides of pixels, with the nodes of what is not closed.
std::vector<Point> middles(const BoundaryChain& chain, Point from, Point to) {
    const std::vector<Point>& path = chain.path;
    std::vector<Point> points;
    if (!chain.closed()) points.push_back(from);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) points.push_back(midpoint(path[i], path[i + 1]));
    points.push_back(chain.closed() ? midpoint(path.back(), path.front()) : to);
    return points;
}

/// The point nearest to `p` of those within `limit` of a place.
Point within(Point p, Point place, double limit) {
    const double distance = length(p - place);
    return distance <= limit ? p : place + (limit / distance) * (p - place);
}

/// Twice the signed area between a line of points and its chord, or inside a closed one.
template <class PointOf>
double doubled_area(std::size_t n, const PointOf& point_of) {
    double sum = 0;
    for (std::size_t i = 1; i < n; ++i) sum += cross(point_of(i - 1) - point_of(0), point_of(i) - point_of(0));
    return sum;
}

}  // namespace

SmoothChain::SmoothChain(const BoundaryChain& chain, Point from, Point to, double spacing)
    : closed_(chain.closed()), spacing_(spacing) {
    const bool straight = chain.on_outline();
    const std::vector<Point> along_pixels = corners(chain, from, to);
    dense_ = straight ? along_pixels : middles(chain, from, to);
    fair_ = dense_;
    restored_.assign(dense_.size(), straight);
    if (!straight) make_smooth(std::clamp(width_over_spacing * spacing_, least_width, most_width));
    smooth_ = fair_;
    take(spacing_);
    requested_area_ = doubled_area(along_pixels.size(), [&](std::size_t i) { return along_pixels[i]; });
    keep_area();
}

void SmoothChain::make_smooth(double width) {
    const std::size_t n = dense_.size();
    if (n < 3) return;
    const int rounds = static_cast<int>(std::ceil(2 * width * width / squared_step));
    std::vector<Point> next = fair_;
    for (int round = 0; round < rounds; ++round) {
        const auto average = [&](std::size_t before, std::size_t i, std::size_t after) {
            const Point p = 0.25 * fair_[before] + 0.5 * fair_[i] + 0.25 * fair_[after];
            next[i] = within(p, dense_[i], farthest);
        };
        for (std::size_t i = 1; i + 1 < n; ++i) average(i - 1, i, i + 1);
        if (closed_) {
            average(n - 1, 0, 1);
            average(n - 2, n - 1, 0);
        }
        fair_.swap(next);
    }
}

std::size_t SmoothChain::least_points() const {
    if (closed_) return std::min(least_points_closed, dense_.size());
    // A loop from a node back to it needs two points more.
    const bool loop = dense_.front() == dense_.back();
    return std::min<std::size_t>(loop ? 5 : 2, dense_.size());
}

void SmoothChain::take(double spacing) {
    const std::size_t n = smooth_.size();
    std::vector<double> along(n, 0);
    for (std::size_t i = 1; i < n; ++i) along[i] = along[i - 1] + length(smooth_[i] - smooth_[i - 1]);
    const double whole = along.back() + (closed_ ? length(smooth_.front() - smooth_.back()) : 0);
    const std::size_t most = closed_ ? n : n - 1;
    const double requested = std::min(std::round(whole / spacing), static_cast<double>(most));
    const std::size_t least = closed_ ? least_points() : least_points() - 1;
    const std::size_t segments = std::max({least, static_cast<std::size_t>(requested), std::size_t{1}});
    taken_.assign(1, 0);
    for (std::size_t k = 1; k < segments; ++k) {
        const double target = whole * static_cast<double>(k) / static_cast<double>(segments);
        auto i = static_cast<std::size_t>(std::lower_bound(along.begin(), along.end(), target) - along.begin());
        if (i > 0 && (i == n || target - along[i - 1] < along[i] - target)) --i;
        // Enough points are left for the segments to come.
        taken_.push_back(std::clamp(i, taken_.back() + 1, most - (segments - k)));
    }
    if (!closed_) taken_.push_back(n - 1);
}

/// Moves the smooth line so that the points taken enclose with the chord, or all around, the area that the pixels do.
void SmoothChain::keep_area() {
    smooth_ = fair_;
    // The directions of a line that was moved differ a little from those before.
    for (int round = 0; round < 3; ++round) move_along_normals();
}

void SmoothChain::move_along_normals() {
    const std::size_t n = smooth_.size();
    if (n < 3 || size() < 3) return;
    const auto taken_point = [&](std::size_t i) { return smooth_[taken_[i]]; };
    const double missing = requested_area_ - doubled_area(size(), taken_point);

    // Near its nodes the line moves less.
    std::vector<double> along(n, 0);
    for (std::size_t i = 1; i < n; ++i) along[i] = along[i - 1] + length(smooth_[i] - smooth_[i - 1]);
    const double reach = std::min(spacing_, along.back() / static_cast<double>(n_segments()));
    std::vector<Point> direction(n);
    for (std::size_t i = closed_ ? 0 : 1; i < (closed_ ? n : n - 1); ++i) {
        const Point tangent = smooth_[(i + 1) % n] - smooth_[(i + n - 1) % n];
        if (restored_[i] || squared_length(tangent) == 0) continue;
        const double near = closed_ ? 1 : std::min({1.0, 2 * along[i] / reach, 2 * (along[n - 1] - along[i]) / reach});
        direction[i] = near * left_of(unit(tangent));
    }
    const auto moved = [&](std::size_t i) { return smooth_[taken_[i]] + direction[taken_[i]]; };
    const auto moved_back = [&](std::size_t i) { return smooth_[taken_[i]] - direction[taken_[i]]; };
    const double change = 0.5 * (doubled_area(size(), moved) - doubled_area(size(), moved_back));
    if (std::abs(change) < 1e-9) return;
    const double limit = 0.5 + 0.5 * reach;
    const double distance = std::clamp(missing / change, -limit, limit);
    for (std::size_t i = 0; i < n; ++i) smooth_[i] = smooth_[i] + distance * direction[i];
}

bool SmoothChain::restore(std::size_t i) {
    const auto n = static_cast<std::ptrdiff_t>(dense_.size());
    bool changed = false;
    for (std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i) - 1; k <= static_cast<std::ptrdiff_t>(i) + 1; ++k) {
        if (!closed_ && (k < 0 || k >= n)) continue;
        const auto p = static_cast<std::size_t>((k + n) % n);
        if (restored_[p] || (!closed_ && (k == 0 || k + 1 == n))) continue;
        restored_[p] = true;
        fair_[p] = dense_[p];
        changed = true;
    }
    return changed;
}

bool SmoothChain::refine(const std::vector<std::size_t>& segments) {
    std::vector<std::size_t> added;
    bool changed = false;
    for (const std::size_t s : segments) {
        const std::size_t from = taken_[s];
        const std::size_t to = s + 1 < size() ? taken_[s + 1] : dense_.size();
        if (to - from > 1) {
            added.push_back((from + to) / 2);
        } else {
            changed = restore(from) || changed;
            changed = restore(to % dense_.size()) || changed;
        }
    }
    const auto middle = static_cast<std::ptrdiff_t>(taken_.size());
    taken_.insert(taken_.end(), added.begin(), added.end());
    std::inplace_merge(taken_.begin(), taken_.begin() + middle, taken_.end());
    changed = changed || !added.empty();
    if (changed) keep_area();
    return changed;
}

}  // namespace graincrack::mesher
