#include "mesher/cells/short_edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "mesher/cells/polygon.hpp"

namespace graincrack::mesher {

namespace {

constexpr int rounds = 2;

/// Merges points of cells.
class Merger {
public:
    Merger(PlaneCells& cells, std::size_t n_fixed, double short_below)
        : cells_(cells),
          n_fixed_(n_fixed),
          short_below_(short_below),
          cells_of_point_(cells.points.size()),
          is_outer_(cells.points.size(), 0) {
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            const auto loop = cells.loop(cell);
            loops_.emplace_back(loop.begin(), loop.end());
            for (const int p : loop) cells_of_point_[index(p)].push_back(static_cast<int>(cell));
        }
        for (const Side& side : cells.sides) {
            is_outer_[index(side.from)] = is_outer_[index(side.to)] = 1;
            along_.push_back(edge_between(side.from, side.to));
        }
        areas_ = areas_of(cells);
    }

    /// An edge with its length, m; points ascending.
    struct Each {
        double length;
        int p, q;
        friend bool operator<(const Each& a, const Each& b) {
            return std::tie(a.length, a.p, a.q) < std::tie(b.length, b.p, b.q);
        }
    };

    /// Short edges, the shortest first.
    [[nodiscard]] std::vector<Each> short_edges() const {
        std::vector<Each> found;
        for (const auto& loop : loops_) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int p = loop[i];
                const int q = loop[(i + 1) % loop.size()];
                const Each each{length(at(q) - at(p)), std::min(p, q), std::max(p, q)};
                if (is_short(each)) found.push_back(each);
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(
            std::unique(found.begin(), found.end(), [](const Each& a, const Each& b) { return a.p == b.p && a.q == b.q; }),
            found.end());
        return found;
    }

    /// Merges the ends of an edge if it still exists, is short, and can be removed.
    bool merge(const Each& edge) {
        const std::vector<int> beside = cells_beside(edge.p, edge.q);
        if (beside.empty() || !is_short({length(at(edge.q) - at(edge.p)), edge.p, edge.q})) return false;
        for (const int cell : beside) {
            if (loops_[index(cell)].size() < 4) return false;
        }
        // Otherwise two cells that share both ends but not the edge would meet in a point.
        for (const int cell : cells_of_point_[index(edge.p)]) {
            if (has(cells_of_point_[index(edge.q)], cell) && !has(beside, cell)) return false;
        }
        const auto target = place(edge.p, edge.q, beside.size() == 1 || is_along_wall(edge.p, edge.q));
        if (!target) return false;
        const auto& [kept, position] = *target;
        const int gone = kept == edge.p ? edge.q : edge.p;
        for (const int point : {kept, gone}) {
            for (const int cell : cells_of_point_[index(point)]) {
                if (!is_sound(moved_loop(index(cell), kept, gone, position))) return false;
            }
        }
        cells_.points[index(kept)] = position;
        for (const int cell : cells_of_point_[index(gone)]) {
            auto& loop = loops_[index(cell)];
            const auto found = std::find(loop.begin(), loop.end(), gone);
            if (has(beside, cell)) {
                loop.erase(found);
            } else {
                *found = kept;
                cells_of_point_[index(kept)].push_back(cell);
            }
        }
        cells_of_point_[index(gone)].clear();
        replaced_.push_back({gone, kept});
        for (Edge& e : along_) {
            if (e[0] == gone || e[1] == gone) e = edge_between(kept, e[0] == gone ? e[1] : e[0]);
        }
        is_outer_[index(kept)] = static_cast<char>(is_outer_[index(kept)] | is_outer_[index(gone)]);
        return true;
    }

    /// Writes loops, edges and sides back without removed points.
    void finish() {
        std::vector<int> number(cells_.points.size(), -1);
        int n = 0;
        for (std::size_t p = 0; p < cells_.points.size(); ++p) {
            if (cells_of_point_[p].empty()) continue;
            number[p] = n;
            cells_.points[index(n++)] = cells_.points[p];
        }
        cells_.points.resize(index(n));
        std::reverse(replaced_.begin(), replaced_.end());  // a replacement may have been replaced later
        for (const auto& [gone, kept] : replaced_) number[index(gone)] = number[index(kept)];
        cells_.corners.clear();
        cells_.start = {0};
        cells_.edges.clear();
        for (const auto& loop : loops_) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int p = number[index(loop[i])];
                const int q = number[index(loop[(i + 1) % loop.size()])];
                cells_.corners.push_back(p);
                cells_.edges.push_back(edge_between(p, q));
            }
            cells_.start.push_back(static_cast<int>(cells_.corners.size()));
        }
        std::sort(cells_.edges.begin(), cells_.edges.end());
        cells_.edges.erase(std::unique(cells_.edges.begin(), cells_.edges.end()), cells_.edges.end());
        std::vector<Side> sides;
        for (Side side : cells_.sides) {
            side.from = number[index(side.from)];
            side.to = number[index(side.to)];
            if (side.from != side.to) sides.push_back(side);
        }
        cells_.sides = std::move(sides);
    }

private:
    static bool has(const std::vector<int>& items, int item) {
        return std::find(items.begin(), items.end(), item) != items.end();
    }
    [[nodiscard]] Point at(int p) const { return cells_.points[index(p)]; }

    /// The cells that have an edge as a side.
    [[nodiscard]] std::vector<int> cells_beside(int p, int q) const {
        std::vector<int> beside;
        for (const int cell : cells_of_point_[index(p)]) {
            const auto& loop = loops_[index(cell)];
            const auto found = std::find(loop.begin(), loop.end(), p);
            const int next = found + 1 == loop.end() ? loop.front() : *(found + 1);
            const int last = found == loop.begin() ? loop.back() : *(found - 1);
            if (next == q || last == q) beside.push_back(cell);
        }
        return beside;
    }

    [[nodiscard]] bool is_along_wall(int p, int q) const {
        return std::find(along_.begin(), along_.end(), edge_between(p, q)) != along_.end();
    }

    [[nodiscard]] bool is_short(const Each& edge) const {
        double area = INFINITY;
        for (const int cell : cells_beside(edge.p, edge.q)) area = std::min(area, areas_[index(cell)]);
        return edge.length < short_below_ * std::sqrt(area);
    }

    /// The end of an edge that stays, and its new place; empty if both are fixed.
    [[nodiscard]] std::optional<std::pair<int, Point>> place(int p, int q, bool is_along_boundary) const {
        const auto is_fixed = [&](int point) { return index(point) < n_fixed_; };
        const auto is_outer = [&](int point) { return is_outer_[index(point)] != 0; };
        if (is_fixed(p) && is_fixed(q)) return std::nullopt;
        if (is_outer(p) && is_outer(q) && !is_along_boundary) return std::nullopt;
        if (is_fixed(p) || is_fixed(q)) return std::pair(is_fixed(p) ? p : q, at(is_fixed(p) ? p : q));
        if (is_outer(p) != is_outer(q)) return std::pair(is_outer(p) ? p : q, at(is_outer(p) ? p : q));
        return std::pair(p, midpoint(at(p), at(q)));
    }

    [[nodiscard]] std::vector<Point> moved_loop(std::size_t cell, int kept, int gone, Point position) const {
        std::vector<Point> points;
        bool is_there = false;
        for (const int p : loops_[cell]) {
            if (p != kept && p != gone) {
                points.push_back(at(p));
            } else if (!std::exchange(is_there, true)) {
                points.push_back(position);
            }
        }
        return points;
    }

    PlaneCells& cells_;
    std::size_t n_fixed_;
    double short_below_;
    std::vector<std::vector<int>> loops_;
    std::vector<std::vector<int>> cells_of_point_;
    std::vector<char> is_outer_;
    std::vector<Edge> along_;    ///< edges of the boundary and prescribed edges
    std::vector<double> areas_;  ///< areas before the first merge
    std::vector<std::pair<int, int>> replaced_;
};

}  // namespace

ShortEdges remove_short_edges(PlaneCells& cells, std::size_t n_fixed, double short_below) {
    Merger merger(cells, n_fixed, short_below);
    ShortEdges result;
    for (int round = 0; round < rounds; ++round) {
        for (const auto& edge : merger.short_edges()) {
            if (merger.merge(edge)) ++result.n_removed;
        }
    }
    result.n_left = merger.short_edges().size();
    merger.finish();
    return result;
}

}  // namespace graincrack::mesher
