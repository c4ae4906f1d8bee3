#include "mesher/region/fit_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

// The last three lengths are over the mean edge; they were chosen by trial and not varied since.
constexpr double same_place = 1e-9;      ///< distance of equal places, over the extent of a region, as for fixed seeds
constexpr double shortest_piece = 0.5;   ///< shortest piece
constexpr double longest_move = 1.2;     ///< longest move of an end of an edge that is not needed
constexpr double sample_distance = 0.2;  ///< distance of the points of a piece whose depth inside the region is tested

Curve curve_of(const PrescribedEdge& e) { return {Curve::Kind::prescribed, e.from, e.to, unit(e.to - e.from), {}}; }

class Fitting {
public:
    Fitting(const Region& region, double edge) : loops_{region.name, region.loops, {}}, edge_(edge) {
        const Box box = bounds(region);
        tolerance_ = same_place * (box.width() + box.height());
        near_ = closest_ends * edge;
        for (const Loop& loop : region.loops) corners_.insert(corners_.end(), loop.corners.begin(), loop.corners.end());
        if (is_round(region)) add_poles(*region.loops.front().circle);
    }

    void add(const PrescribedEdge& whole) {
        std::vector<PrescribedEdge> pieces = clip(loops_, whole);
        if (pieces.empty() && whole.needed) throw UsageError(whole.name + ": lies outside of the specimen or along its boundary");
        for (PrescribedEdge& piece : pieces) {
            const auto fault = place(piece);
            if (fault && piece.needed) throw UsageError(whole.name + ": " + *fault);
        }
    }

    std::vector<PrescribedEdge> edges() && { return std::move(placed_); }

    /// A sentence for each end of a needed edge that moved by more than `told_move` edges.
    [[nodiscard]] std::vector<std::string> moves() const {
        std::vector<std::string> sentences;
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            const PrescribedEdge &now = placed_[i], &before = requested_[i];
            for (const double move : {length(now.from - before.from), length(now.to - before.to)}) {
                if (!now.needed || move <= told_move * edge_) continue;
                sentences.push_back(fmt::format("{}: an end was moved by {} to what it almost met; its length is {}, not {}",
                                                now.name, format_length(move), format_length(length(now.to - now.from)),
                                                format_length(length(before.to - before.from))));
            }
        }
        return sentences;
    }

private:
    using Fault = std::optional<std::string>;

    /// Adds the points of a mesh at both ends of each diameter of a circle.
    void add_poles(const Circle& circle) {
        const double half_facet = circle.pole == Pole::facet ? edge_ / (2 * circle.radius) : 0;
        for (int pole = 0; pole < 2 * circle.diameters; ++pole) {
            const double middle = (0.5 + static_cast<double>(pole) / circle.diameters) * std::numbers::pi;
            for (const double angle : {middle - half_facet, middle + half_facet}) {
                corners_.push_back(circle.centre + circle.radius * Point{std::cos(angle), std::sin(angle)});
            }
        }
    }

    /// Adds a piece and moves the ends of others to it, or returns why it does not fit.
    Fault place(PrescribedEdge piece) {
        const std::vector<PrescribedEdge> before = placed_;
        requested_.push_back(piece);
        snap_to_loops(piece);
        for (const PrescribedEdge& other : placed_) snap(piece, other);
        for (PrescribedEdge& other : placed_) snap(other, piece);
        Fault fault = fault_of(piece, placed_.size());
        for (std::size_t i = 0; i < before.size() && !fault; ++i) {
            if (placed_[i].from == before[i].from && placed_[i].to == before[i].to) continue;
            fault = fault_of(placed_[i], i);
            if (!fault) fault = fault_between(placed_[i], piece);
        }
        placed_.push_back(piece);
        for (std::size_t i = 0; i + 1 < placed_.size() && !fault; ++i) fault = fault_of_stations(i, piece);
        if (!fault) fault = fault_of_stations(placed_.size() - 1, piece);
        if (fault) {
            placed_ = before;
            requested_.pop_back();
        }
        return fault;
    }

    /// Position along `a` (0 to 1 within it) at which its line meets the segment of `b`; empty if it does not.
    [[nodiscard]] std::optional<double> meeting(const PrescribedEdge& a, const PrescribedEdge& b) const {
        const Point u = a.to - a.from;
        const Point v = b.to - b.from;
        const double sine = cross(u, v);
        if (std::abs(sine) <= same_place * length(u) * length(v)) return std::nullopt;
        const double on_b = cross(b.from - a.from, u) / sine;
        const double slack = tolerance_ / length(v);
        if (on_b < -slack || on_b > 1 + slack) return std::nullopt;
        return cross(b.from - a.from, v) / sine;
    }

    /// Moves the ends of a piece that almost meet another to where their lines meet.
    void snap(PrescribedEdge& piece, const PrescribedEdge& other) const {
        for (Point* end : {&piece.from, &piece.to}) {
            for (const Point goal : {other.from, other.to}) {
                if (length(*end - goal) < tolerance_) *end = goal;
            }
            const double distance = curve_of(other).distance(*end);
            if (distance >= near_ || distance <= tolerance_) continue;
            const auto share = meeting(piece, other);
            if (share) move(piece, *end, piece.from + *share * (piece.to - piece.from));
        }
    }

    void move(PrescribedEdge& piece, Point& end, Point goal) const {
        const Point other_end = &end == &piece.from ? piece.to : piece.from;
        const double limit = longest_move * edge_;
        if (length(goal - end) > limit || length(goal - other_end) < shortest_piece * edge_) return;
        if (depth_inside(loops_, goal) < -tolerance_) return;
        end = goal;
    }

    /// Moves the ends of a piece that almost meet a loop onto it.
    void snap_to_loops(PrescribedEdge& piece) const {
        for (Point* end : {&piece.from, &piece.to}) {
            const double depth = depth_inside(loops_, *end);
            if (depth >= near_ || depth <= tolerance_) continue;
            const Point start = end == &piece.from ? piece.to : piece.from;
            const Point beyond = *end + longest_move * edge_ * unit(*end - start);
            const auto longer = clip(loops_, {start, beyond});
            if (!longer.empty() && longer.front().from == start) move(piece, *end, longer.front().to);
        }
    }

    [[nodiscard]] Fault fault_of(const PrescribedEdge& piece, std::size_t index) const {
        if (Fault fault = fault_at_loops(piece)) return fault;
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            if (i == index) continue;
            if (Fault fault = fault_between(piece, placed_[i])) return fault;
        }
        const PrescribedEdge& requested = requested_[index];
        const double moved = std::max(length(piece.from - requested.from), length(piece.to - requested.to));
        if (!piece.needed || moved <= near_) return std::nullopt;
        return fmt::format("an end would move by {} to what it almost meets; end it there or {} away", format_length(moved),
                           format_length(near_));
    }

    [[nodiscard]] Fault fault_at_loops(const PrescribedEdge& piece) const {
        const double whole = length(piece.to - piece.from);
        if (whole < shortest_piece * edge_) {
            return fmt::format(
                "{} inside of the specimen is less than half a grain edge of {}; make it longer or the grains smaller",
                format_length(whole), format_length(edge_));
        }
        const Point along = unit(piece.to - piece.from);
        const bool starts_on_loop = std::abs(depth_inside(loops_, piece.from)) <= tolerance_;
        const bool ends_on_loop = std::abs(depth_inside(loops_, piece.to)) <= tolerance_;
        for (const auto& [on_loop, end] : {std::pair{starts_on_loop, piece.from}, std::pair{ends_on_loop, piece.to}}) {
            if (!on_loop) continue;
            for (const Point corner : corners_) {
                const double distance = length(corner - end);
                if (distance > tolerance_ && distance < near_) {
                    return fmt::format("it meets the boundary {} from a corner or pole; end it there or {} away",
                                       format_length(distance), format_length(near_));
                }
            }
        }
        const int n = 1 + static_cast<int>(whole / (sample_distance * edge_));
        const double sine = std::sin(sharpest_meeting);
        for (int k = 0; k <= n; ++k) {
            const double s = whole * k / n;
            const double from_loop = std::min(starts_on_loop ? s : whole, ends_on_loop ? whole - s : whole);
            const double least = std::min(near_, sine * from_loop) - tolerance_;
            const double depth = least > 0 ? depth_inside(loops_, piece.from + s * along) : near_;
            if (depth < least) {
                return fmt::format("it runs {} beside the boundary; keep {} away or meet it under more than 15 deg",
                                   format_length(depth), format_length(near_));
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] Fault fault_between(const PrescribedEdge& a, const PrescribedEdge& b) const {
        const auto share = meeting(a, b);
        const double whole = length(a.to - a.from);
        const double slack = tolerance_ / whole;
        if (share && *share >= -slack && *share <= 1 + slack) {
            const Point at = a.from + *share * (a.to - a.from);
            double angle = std::numbers::pi;
            for (const Point p : {a.from, a.to}) {
                for (const Point q : {b.from, b.to}) {
                    const Point u = p - at;
                    const Point v = q - at;
                    if (length(u) > tolerance_ && length(v) > tolerance_) {
                        angle = std::min(angle, std::atan2(std::abs(cross(u, v)), dot(u, v)));
                    }
                }
            }
            if (angle >= sharpest_meeting) return std::nullopt;
            return fmt::format("meets {} under {:.3g} deg; at least 15 deg fits", b.name, angle * 180 / std::numbers::pi);
        }
        const double distance = std::min(
            {curve_of(a).distance(b.from), curve_of(a).distance(b.to), curve_of(b).distance(a.from), curve_of(b).distance(a.to)});
        if (distance >= near_) return std::nullopt;
        // Two pieces that continue each other on one line share one end only.
        if (distance <= tolerance_ && share_an_end(a, b) && dot(outward(a, b), outward(b, a)) < 0) return std::nullopt;
        if (distance <= tolerance_) return "lies upon " + b.name;
        return fmt::format("comes within {} of {} without meeting it; at least {} fits, with grain edges of {}",
                           format_length(distance), b.name, format_length(near_), format_length(edge_));
    }

    [[nodiscard]] bool share_an_end(const PrescribedEdge& a, const PrescribedEdge& b) const {
        return std::min({length(a.from - b.from), length(a.from - b.to), length(a.to - b.from), length(a.to - b.to)}) <=
               tolerance_;
    }
    /// The direction of a piece away from the end that it shares with another.
    [[nodiscard]] Point outward(const PrescribedEdge& a, const PrescribedEdge& b) const {
        const bool at_start = std::min(length(a.from - b.from), length(a.from - b.to)) <= tolerance_;
        return at_start ? a.to - a.from : a.from - a.to;
    }

    /// Says why a piece does not fit whose meetings with others are too near to each other or to its ends. Pieces that do not
    /// meet `cause` are left out.
    [[nodiscard]] Fault fault_of_stations(std::size_t index, const PrescribedEdge& cause) const {
        const PrescribedEdge& piece = placed_[index];
        const bool is_cause = index + 1 == placed_.size();
        const double whole = length(piece.to - piece.from);
        const double slack = tolerance_ / whole;
        const auto inside = [&](std::optional<double> share) { return share && *share >= -slack && *share <= 1 + slack; };
        if (!is_cause && !inside(meeting(piece, cause))) return std::nullopt;
        std::vector<std::pair<double, std::size_t>> stations{{0, index}, {whole, index}};
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            if (i == index) continue;
            const auto share = meeting(piece, placed_[i]);
            if (inside(share)) stations.emplace_back(*share * whole, i);
        }
        std::sort(stations.begin(), stations.end());
        for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
            const double gap = stations[i + 1].first - stations[i].first;
            if (gap <= tolerance_ || gap >= near_) continue;
            const std::string& name = placed_[stations[stations[i].second == index ? i + 1 : i].second].name;
            return fmt::format("crosses {} {} from an end or another crossing; at least {} fits, with grain edges of {}", name,
                               format_length(gap), format_length(near_), format_length(edge_));
        }
        return std::nullopt;
    }

    Region loops_;  ///< the region without edges
    double edge_, tolerance_ = 0, near_ = 0;
    std::vector<Point> corners_;  ///< points of loops that cannot move
    std::vector<PrescribedEdge> placed_;
    std::vector<PrescribedEdge> requested_;  ///< the same pieces before any end moved
};

}  // namespace

std::vector<PrescribedEdge> fitted_edges(const Region& region, double edge, std::vector<std::string>* moves) {
    Fitting fitting(region, edge);
    for (const bool needed : {true, false}) {  // needed edges first
        for (const PrescribedEdge& e : region.edges) {
            if (e.needed == needed) fitting.add(e);
        }
    }
    if (moves != nullptr) *moves = fitting.moves();
    return std::move(fitting).edges();
}

}  // namespace graincrack::mesher
