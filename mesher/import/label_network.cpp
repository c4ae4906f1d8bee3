#include "mesher/import/label_network.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <tuple>

namespace graincrack::mesher {

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
