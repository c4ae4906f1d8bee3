#include "mesher/import/label_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace graincrack::mesher {

namespace {

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

std::vector<std::size_t> crowded_segments(std::span<const Point> points, std::span<const Edge> segments,
                                          const Clearance& clearance) {
    return Crowding(points, segments, clearance).run();
}

}  // namespace graincrack::mesher
