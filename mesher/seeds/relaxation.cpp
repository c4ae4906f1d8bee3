#include "mesher/seeds/relaxation.hpp"

#include <algorithm>
#include <utility>

#include "mesher/plane/triangulation.hpp"
#include "mesher/seeds/orientation.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

// Measured on 1,122 and 452 grains, 40 seeds each: more rounds or sweeps change spread and smallest angle by about 2 %.
constexpr int n_ordering_rounds = 4;  ///< rounds with springs that act at any length and order the neighbourhoods
constexpr int n_range_rounds = 4;     ///< rounds with springs that act outside of the range only and reduce extreme edges
constexpr int n_settling_rounds = 2;  ///< last rounds, without splits and merges
constexpr int max_extra_rounds = 60;  ///< further rounds to meet the number of points
constexpr int n_sweeps = 6;
constexpr double relaxation_factor = 0.3;  ///< fraction of a spring move that a sweep makes; chosen by trial, as the next numbers
constexpr double split_above = 1.28;       ///< over the requested edge
constexpr double merge_below = 0.78;       ///< over the requested edge
constexpr double turning = 0.19;           ///< rotation away from a common direction
constexpr int n_smoothings = 10;           ///< a neighbourhood has a radius of about three edges
constexpr double ordered_spread = 0.115;   ///< larger spreads need no ordering rounds
constexpr double min_depth = 0.3;          ///< smallest depth of inner points, over the requested edge
constexpr double least_scatter = 0.01;     ///< bounds of the scatter of the logarithm of sizes
constexpr double largest_scatter = 0.6;

/// Half range of the springs that gives a spread on average. Fitted to meshes; the rounds correct it.
double initial_range(double spread) {
    return spread > ordered_spread ? 1.6 * spread - 0.04 : std::clamp(3 * (spread - 0.095), 0.0, 0.1);
}

class Relaxation {
public:
    Relaxation(const DepthGrid& depth, Seeds fixed, const std::vector<Point>& inner, const RelaxationGoal& goal, SizeField size)
        : depth_(depth), goal_(goal), size_(std::move(size)), n_fixed_(fixed.n_fixed), mesh_(std::move(fixed)) {
        for (const Side& side : mesh_.sides) {
            (side.part >= 0 ? loops_ : prescribed_).push_back({side.from, side.to});
            fixed_edges_.push_back({std::min(side.from, side.to), std::max(side.from, side.to)});
        }
        std::sort(fixed_edges_.begin(), fixed_edges_.end());
        // The sides of one convex loop are sides of all Delaunay triangles.
        is_hull_ = n_fixed_ == mesh_.sides.size() && loops_.size() == n_fixed_ && is_convex(mesh_.points);
        mesh_.points.insert(mesh_.points.end(), inner.begin(), inner.end());
        range_ = initial_range(spring_spread());
    }

    Seeds run(const ProgressCallback& progress) {
        const int n_ordering = spring_spread() > ordered_spread ? 0 : n_ordering_rounds;
        const int n_rounds = n_ordering + n_range_rounds;
        for (int round = 0;; ++round) {
            triangulate();
            if (round >= n_rounds && surplus() == 0) break;
            if (round >= n_rounds + max_extra_rounds) {
                throw NumericalError("the mesh does not reach its number of grains; choose a smaller edge or more grains");
            }
            throw_if_interrupted();
            if (progress) progress(std::min(1.0, static_cast<double>(round) / n_rounds));
            const bool settling = round >= n_rounds - n_settling_rounds;
            sweep(round < n_ordering ? 0.0 : adapted_range());
            if (!settling || surplus() != 0) exchange_points(settling);
        }
        return std::move(mesh_);
    }

private:
    [[nodiscard]] std::ptrdiff_t surplus() const {
        return static_cast<std::ptrdiff_t>(mesh_.points.size()) - static_cast<std::ptrdiff_t>(n_fixed_ + goal_.n_inner);
    }
    [[nodiscard]] double edge_length(const Edge& e) const {
        return length(mesh_.points[index(e[1])] - mesh_.points[index(e[0])]);
    }
    /// Relative size of an edge, the mean of those of its ends.
    [[nodiscard]] double size_of(const Edge& e) const {
        return sizes_.empty() ? 1 : 0.5 * (sizes_[index(e[0])] + sizes_[index(e[1])]);
    }
    /// Spread that the springs leave; a larger one comes from the sizes.
    [[nodiscard]] double spring_spread() const { return size_.is_scattered() ? tight_spread : goal_.spread; }

    void triangulate() {
        if (!is_hull_) {
            mesh_.triangles = constrained_triangles(mesh_.points, loops_, prescribed_);
        } else if (points_changed_) {
            delaunay_.build(mesh_.points);
        } else {
            delaunay_.move(mesh_.points);
        }
        points_changed_ = false;
        if (is_hull_) mesh_.triangles = delaunay_.triangles();
        // Corners are split already during the relaxation, so that the spring along the new diagonal shortens it.
        for (const Corner& c : mesh_.corners) {
            if (is_fixed({std::min(c.before, c.after), std::max(c.before, c.after)})) {
                continue;  // a prescribed edge cuts the corner
            }
            split_corner_ear(mesh_.points, mesh_.triangles, c.at, c.before, c.after);
        }
        mesh_.edges = edges_of(mesh_.triangles, mesh_.points.size());
        take_sizes();
    }

    /// Relative sizes at the points.
    void take_sizes() {
        if (!has_sizes_) return;
        sizes_.resize(mesh_.points.size());
        for (std::size_t i = 0; i < sizes_.size(); ++i) sizes_[i] = size_.at(mesh_.points[i]);
    }

    [[nodiscard]] double spread() const { return spread_of_edges(mesh_.points, mesh_.edges, size_); }

    /// Half range in which springs exert no force. It, or the scatter of sizes, is corrected by the difference between requested
    /// and present spread.
    double adapted_range() {
        const double missing = goal_.spread - spread();
        if (size_.is_scattered()) {
            size_.set_scatter(std::clamp(size_.scatter() + 1.5 * missing, least_scatter, largest_scatter));
            take_sizes();
        } else {
            range_ = std::max(0.0, range_ + 1.5 * missing);
        }
        return range_;
    }

    /// Sweeps over the inner points. Springs to its neighbours and the rotation of its edges move each point in turn.
    void sweep(double range) {
        const Neighbours neighbours = neighbours_of(mesh_.edges, mesh_.points.size());
        const auto turns = turning_moves(neighbours);
        auto& points = mesh_.points;
        const double longest = (1 + range) * goal_.edge;
        const double shortest = (1 - range) * goal_.edge;
        const double degenerate = 1e-3 * goal_.edge;
        const double depth = min_depth * goal_.edge;
        const bool sized = !sizes_.empty();
        for (int pass = 0; pass < n_sweeps; ++pass) {
            for (std::size_t i = n_fixed_; i < points.size(); ++i) {
                Point move = turns[i];
                for (int k = neighbours.start[i]; k < neighbours.start[i + 1]; ++k) {
                    const auto j = index(neighbours.items[index(k)]);
                    const Point d = points[j] - points[i];
                    const double l = std::max(length(d), degenerate);
                    const double size = sized ? 0.5 * (sizes_[i] + sizes_[j]) : 1;
                    const double aim = std::clamp(l, size * shortest, size * longest);
                    move = move + (1 - aim / l) * d;
                }
                const double local_depth = sized ? sizes_[i] * depth : depth;
                points[i] = depth_.kept_deep(points[i] + relaxation_factor * move, local_depth, points[i]);
            }
        }
    }

    /// Moves that rotate the edges of each point away from the common direction o of its neighbourhood: down the gradient of
    /// |⟨e^(6iθ)⟩|², whose sine is Im(e^(6iθ) ō).
    [[nodiscard]] std::vector<Point> turning_moves(const Neighbours& neighbours) const {
        const auto& points = mesh_.points;
        const auto orientation = local_orientation(points, neighbours, n_smoothings);
        std::vector<Point> moves(points.size());
        for (std::size_t i = n_fixed_; i < points.size(); ++i) {
            const Point o = orientation[i];
            for (int k = neighbours.start[i]; k < neighbours.start[i + 1]; ++k) {
                const Point d = points[index(neighbours.items[index(k)])] - points[i];
                const Point v = six_fold(d);
                const double sine = v.y * o.x - v.x * o.y;
                moves[i] = moves[i] + (-turning * sine) * Point{-d.y, d.x};
            }
        }
        return moves;
    }

    /// Merges the ends of the shortest edges and splits the longest, equally many of both except to correct the number of points.
    /// \param only_correct do no more than this correction
    void exchange_points(bool only_correct) {
        Candidates short_edges;
        Candidates long_edges;
        const std::ptrdiff_t missing = -surplus();
        const double low = missing < 0 ? 1e9 : merge_below;  // a correction may use all edges
        const double high = missing > 0 ? 0.0 : split_above;
        std::ptrdiff_t n_too_short = 0;
        std::ptrdiff_t n_too_long = 0;
        for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
            if (is_fixed(mesh_.edges[e])) continue;
            const double l = edge_length(mesh_.edges[e]) / (size_of(mesh_.edges[e]) * goal_.edge);
            if (l < merge_below) ++n_too_short;
            if (l > split_above) ++n_too_long;
            const bool has_inner_end = index(mesh_.edges[e][1]) >= n_fixed_;
            if (l < low && has_inner_end) short_edges.emplace_back(l, e);
            if (l > high) long_edges.emplace_back(-l, e);
        }
        const std::ptrdiff_t n_pairs = only_correct ? 0 : std::max<std::ptrdiff_t>(0, std::min(n_too_short, n_too_long));
        std::ptrdiff_t n_merges = std::max<std::ptrdiff_t>(0, n_pairs - std::max<std::ptrdiff_t>(0, missing));
        if (missing < 0) n_merges = std::max(n_merges, -missing);
        const std::ptrdiff_t n_splits = n_merges + missing;
        sort_first(short_edges, n_merges);
        sort_first(long_edges, n_splits);
        apply_exchange(short_edges, n_merges, long_edges, n_splits);
    }

    using Candidates = std::vector<std::pair<double, std::size_t>>;

    /// Sorts as many candidates to the front as a choice of `n` without common points may need, and drops the others. If too few
    /// are left, the next round corrects the number.
    static void sort_first(Candidates& candidates, std::ptrdiff_t n) {
        const auto n_kept = std::min(static_cast<std::ptrdiff_t>(candidates.size()), 3 * n + 20);
        std::partial_sort(candidates.begin(), candidates.begin() + n_kept, candidates.end());
        candidates.resize(static_cast<std::size_t>(n_kept));
    }

    [[nodiscard]] bool is_fixed(const Edge& e) const {
        return index(e[1]) < n_fixed_ && std::binary_search(fixed_edges_.begin(), fixed_edges_.end(), e);
    }

    void apply_exchange(const Candidates& short_edges, std::ptrdiff_t n_merges, const Candidates& long_edges,
                        std::ptrdiff_t n_splits) {
        auto& points = mesh_.points;
        std::vector<char> touched(points.size(), 0);
        std::vector<char> merged(points.size(), 0);
        std::vector<std::pair<std::size_t, Point>>
            added;  // new point and the index after which it is inserted, so that neighbours stay near in memory
        const auto take = [&](const Candidates::value_type& candidate) -> const Edge* {
            const Edge& e = mesh_.edges[candidate.second];
            char& p = touched[index(e[0])];
            char& q = touched[index(e[1])];
            if (p != 0 || q != 0) return nullptr;
            p = q = 1;
            return &e;
        };
        for (auto it = short_edges.begin(); it != short_edges.end() && n_merges > 0; ++it) {
            const Edge* e = take(*it);
            if (e == nullptr) continue;
            const auto p = index((*e)[0]);
            const auto q = index((*e)[1]);
            merged[q] = 1;
            if (p >= n_fixed_) points[p] = midpoint(points[p], points[q]);
            --n_merges;
        }
        for (auto it = long_edges.begin(); it != long_edges.end() && n_splits > 0; ++it) {
            const Edge* e = take(*it);
            if (e == nullptr) continue;
            const auto q = index((*e)[1]);
            added.emplace_back(std::max(q, n_fixed_ - 1), midpoint(points[index((*e)[0])], points[q]));
            --n_splits;
        }
        if (added.empty() && std::find(merged.begin(), merged.end(), 1) == merged.end()) return;
        points_changed_ = true;
        std::stable_sort(added.begin(), added.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
        std::vector<Point> next;
        next.reserve(points.size() + added.size());
        auto addition = added.begin();
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (merged[i] == 0) next.push_back(points[i]);
            for (; addition != added.end() && addition->first == i; ++addition) next.push_back(addition->second);
        }
        points = std::move(next);
    }

    const DepthGrid& depth_;
    const RelaxationGoal goal_;
    SizeField size_;
    bool has_sizes_ = size_.varies();
    std::vector<double> sizes_;  ///< [points] relative sizes; empty if all are 1
    std::size_t n_fixed_;
    std::vector<Edge> loops_;        ///< directed
    std::vector<Edge> prescribed_;   ///< directed
    std::vector<Edge> fixed_edges_;  ///< both, ascending
    bool is_hull_ = false;
    double range_ = 0;
    bool points_changed_ = true;  ///< true if points were added or removed
    DelaunayMesh delaunay_;
    Seeds mesh_;
};

}  // namespace

Seeds relax_points(const DepthGrid& depth, Seeds fixed, const std::vector<Point>& inner, const RelaxationGoal& goal,
                   const SizeField& size, const ProgressCallback& progress) {
    return Relaxation(depth, std::move(fixed), inner, goal, size).run(progress);
}

}  // namespace graincrack::mesher
