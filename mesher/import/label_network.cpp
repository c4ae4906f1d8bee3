#include "mesher/import/label_network.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <tuple>

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

namespace {

constexpr Clearance needed{0.5, 20 * std::numbers::pi / 180};

/// Longest over shortest of the segments that meet in a point, and the length in pixels that need not be divided for it.
constexpr double most_ratio = 3;
constexpr double short_enough = 2.5;

/// The segments that are too long beside their neighbours.
std::vector<std::size_t> long_segments(const std::vector<Point>& points, const std::vector<Edge>& segments) {
    std::vector<double> shortest(points.size(), INFINITY);
    const auto at = [](int p) { return static_cast<std::size_t>(p); };
    const auto length_of = [&](const Edge& s) { return length(points[at(s[1])] - points[at(s[0])]); };
    for (const Edge& s : segments) {
        for (const int p : s) shortest[at(p)] = std::min(shortest[at(p)], length_of(s));
    }
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const double least = std::min(shortest[at(segments[i][0])], shortest[at(segments[i][1])]);
        if (length_of(segments[i]) > std::max(most_ratio * least, short_enough)) found.push_back(i);
    }
    return found;
}

/// The network of the chains as they are divided now; the chain of each segment and its number within the chain.
struct Division {
    LabelNetwork network;
    std::vector<std::size_t> chain_of_segment;
    std::vector<std::size_t> number_in_chain;
};

Division divide(const LabelBoundaries& boundaries, const std::vector<SmoothChain>& chains) {
    Division division;
    LabelNetwork& network = division.network;
    network.points = boundaries.nodes;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        const BoundaryChain& boundary = boundaries.chains[c];
        const SmoothChain& chain = chains[c];
        const int first = static_cast<int>(network.points.size());
        const std::size_t begin = boundary.closed() ? 0 : 1;
        const std::size_t end = boundary.closed() ? chain.size() : chain.size() - 1;
        for (std::size_t i = begin; i < end; ++i) network.points.push_back(chain.point(i));
        const auto number = [&](std::size_t i) {
            if (boundary.closed()) return first + static_cast<int>(i % chain.size());
            if (i == 0) return boundary.from;
            return i == end ? boundary.to : first + static_cast<int>(i) - 1;
        };
        for (std::size_t i = 0; i < chain.n_segments(); ++i) {
            network.segments.push_back({number(i), number(i + 1), boundary.left, boundary.right});
            division.chain_of_segment.push_back(c);
            division.number_in_chain.push_back(i);
        }
    }
    return division;
}

double squared_distance_to_segment(Point p, Point a, Point b) {
    const double whole = squared_length(b - a);
    const double t = whole > 0 ? std::clamp(dot(p - a, b - a) / whole, 0.0, 1.0) : 0;
    return squared_length(p - (a + t * (b - a)));
}

bool cross_each_other(Point a, Point b, Point c, Point d) {
    return (cross(b - a, c - a) > 0) != (cross(b - a, d - a) > 0) && (cross(d - c, a - c) > 0) != (cross(d - c, b - c) > 0);
}

/// Segments in the cells of a grid that they come near.
struct Entry {
    std::int32_t column = 0;
    std::int32_t row = 0;
    std::uint32_t segment = 0;
    friend bool operator==(const Entry&, const Entry&) = default;
    friend bool operator<(const Entry& a, const Entry& b) {
        return std::tie(a.column, a.row, a.segment) < std::tie(b.column, b.row, b.segment);
    }
};

class Crowding {
public:
    Crowding(std::span<const Point> points, std::span<const Edge> segments, const Clearance& clearance)
        : points_(points),
          segments_(segments),
          squared_distance_(clearance.distance * clearance.distance),
          cosine_(std::cos(clearance.angle)),
          crowded_(segments.size()) {
        double sum = 0;
        for (const Edge& s : segments_) sum += length(at(s[1]) - at(s[0]));
        cell_ = 2 * (clearance.distance + sum / static_cast<double>(std::max<std::size_t>(segments_.size(), 1)));
        for (std::size_t s = 0; s < segments_.size(); ++s) enter(s, clearance.distance);
        std::sort(entries_.begin(), entries_.end());
        entries_.erase(std::unique(entries_.begin(), entries_.end()), entries_.end());
    }

    std::vector<std::size_t> run() && {
        for (std::size_t begin = 0; begin < entries_.size();) {
            std::size_t end = begin;
            while (end < entries_.size() && entries_[end].column == entries_[begin].column &&
                   entries_[end].row == entries_[begin].row) {
                ++end;
            }
            for (std::size_t i = begin; i < end; ++i) {
                for (std::size_t j = i + 1; j < end; ++j) compare(entries_[i].segment, entries_[j].segment);
            }
            begin = end;
        }
        std::vector<std::size_t> found;
        for (std::size_t s = 0; s < segments_.size(); ++s) {
            if (crowded_[s]) found.push_back(s);
        }
        return found;
    }

private:
    [[nodiscard]] Point at(int p) const { return points_[static_cast<std::size_t>(p)]; }

    /// Enters a segment piece by piece, each no longer than a cell.
    void enter(std::size_t s, double distance) {
        const Point from = at(segments_[s][0]);
        const Point whole = at(segments_[s][1]) - from;
        const double parts = std::ceil(length(whole) / cell_);
        const auto index = [&](double x) { return static_cast<std::int32_t>(std::floor(x / cell_)); };
        for (double k = 0; k < parts; ++k) {
            const Point p = from + (k / parts) * whole;
            const Point q = from + ((k + 1) / parts) * whole;
            for (std::int32_t i = index(std::min(p.x, q.x) - distance); i <= index(std::max(p.x, q.x) + distance); ++i) {
                for (std::int32_t j = index(std::min(p.y, q.y) - distance); j <= index(std::max(p.y, q.y) + distance); ++j) {
                    entries_.push_back({i, j, static_cast<std::uint32_t>(s)});
                }
            }
        }
    }

    void compare(std::size_t s, std::size_t t) {
        if (crowded_[s] && crowded_[t]) return;
        if (are_crowded(segments_[s], segments_[t])) crowded_[s] = crowded_[t] = true;
    }

    [[nodiscard]] bool are_crowded(const Edge& s, const Edge& t) const {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
                if (s[i] != t[j]) continue;
                const Point p = at(s[1 - i]) - at(s[i]);
                const Point q = at(t[1 - j]) - at(t[j]);
                return s[1 - i] == t[1 - j] || dot(p, q) > cosine_ * length(p) * length(q);
            }
        }
        const Point a = at(s[0]);
        const Point b = at(s[1]);
        const Point c = at(t[0]);
        const Point d = at(t[1]);
        return squared_distance_to_segment(a, c, d) < squared_distance_ ||
               squared_distance_to_segment(b, c, d) < squared_distance_ ||
               squared_distance_to_segment(c, a, b) < squared_distance_ ||
               squared_distance_to_segment(d, a, b) < squared_distance_ || cross_each_other(a, b, c, d);
    }

    std::span<const Point> points_;
    std::span<const Edge> segments_;
    double squared_distance_;
    double cosine_;
    double cell_ = 1;
    std::vector<bool> crowded_;
    std::vector<Entry> entries_;
};

}  // namespace

LabelNetwork label_network(const LabelBoundaries& boundaries, double spacing) {
    std::vector<SmoothChain> chains;
    chains.reserve(boundaries.chains.size());
    const auto node = [&](int i) { return i < 0 ? Point{} : boundaries.nodes[static_cast<std::size_t>(i)]; };
    for (const BoundaryChain& chain : boundaries.chains) chains.emplace_back(chain, node(chain.from), node(chain.to), spacing);
    std::vector<bool> refined(chains.size());
    while (true) {
        Division division = divide(boundaries, chains);
        std::vector<Edge> segments;
        for (const RegionEdge& s : division.network.segments) segments.push_back({s.from, s.to});
        bool changed = false;
        const auto refine = [&](const std::vector<std::size_t>& crowded) {
            for (std::size_t i = 0; i < crowded.size();) {
                const std::size_t chain = division.chain_of_segment[crowded[i]];
                std::vector<std::size_t> numbers;
                for (; i < crowded.size() && division.chain_of_segment[crowded[i]] == chain; ++i) {
                    numbers.push_back(division.number_in_chain[crowded[i]]);
                }
                if (!chains[chain].refine(numbers)) continue;
                refined[chain] = true;
                changed = true;
            }
        };
        refine(crowded_segments(division.network.points, segments, needed));
        // Grading comes last: it divides where no two boundaries are in each other's way any more.
        if (!changed) refine(long_segments(division.network.points, segments));
        if (changed) continue;
        division.network.refined_chains = static_cast<int>(std::count(refined.begin(), refined.end(), true));
        return std::move(division.network);
    }
}

std::vector<std::size_t> crowded_segments(std::span<const Point> points, std::span<const Edge> segments,
                                          const Clearance& clearance) {
    return Crowding(points, segments, clearance).run();
}

}  // namespace graincrack::mesher
