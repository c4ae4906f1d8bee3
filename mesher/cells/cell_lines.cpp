#include "mesher/cells/cell_lines.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "mesher/cells/polygon.hpp"

namespace graincrack::mesher {

namespace {

constexpr double same_point = 1e-9;  ///< distance of equal points, over the extent
/// Distance, over the root of the mean area, within which a point of cells moves onto a wall. Chosen by trial.
constexpr double reach_of_lines = 0.2;
constexpr double beside_an_end = 0.01;  ///< fraction of a wall near its ends at which no point is moved onto it

/// The fraction of a line, and the point there.
using Stop = std::pair<double, int>;

class LineMaker {
public:
    LineMaker(const PlaneCells& cells, const Walls& walls, double mean_size, const SizeField& size)
        : cells_(cells), walls_(walls), mean_size_(mean_size), graded_(size), stops_of_wall_(walls.sides.size()) {
        lines_.points = cells.points;
        lines_.sides = walls.sides;
        const std::size_t n = cells.points.size();
        lines_.is_fixed.assign(n, 0);
        std::fill_n(lines_.is_fixed.begin(), walls.hull.size(), 1);
        is_outer_.assign(n, 0);
        cells_at_.resize(n);
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            for (const int p : cells.loop(cell)) cells_at_[index(p)].push_back(cell);
        }
        for (Side side : cells.sides) {
            if (!walls.is_convex) side.part = CellLines::no_wall;
            is_outer_[index(side.from)] = is_outer_[index(side.to)] = 1;
            hull_side_[edge_between(side.from, side.to)] = static_cast<int>(lines_.sides.size());
            lines_.sides.push_back(side);
        }
        const Box box = box_of(walls.hull.corners);
        tolerance_ = same_point * (box.width() + box.height());
    }

    CellLines run() && {
        add_corners();
        snap_to_walls();
        for (std::size_t side = first_wall(); side < walls_.sides.size(); ++side) {
            for (const Edge& edge : cells_.edges) meet(side, edge);
        }
        for (std::size_t w = 0; w < walls_.points.size(); ++w) extend(static_cast<int>(w));
        divide_edges();
        divide_walls();
        return std::move(lines_);
    }

private:
    [[nodiscard]] Point at(int p) const { return lines_.points[index(p)]; }
    [[nodiscard]] double size_at(Point p) const { return mean_size_ * graded_.graded(p); }
    /// Number of the first side of walls that is not one of the hull.
    [[nodiscard]] std::size_t first_wall() const { return walls_.is_convex ? walls_.n_sides_of_outline() : 0; }
    [[nodiscard]] bool is_free(int p) const { return lines_.is_fixed[index(p)] == 0 && is_outer_[index(p)] == 0; }

    int add_point(Point p, bool is_fixed) {
        lines_.points.push_back(p);
        lines_.is_fixed.push_back(is_fixed ? 1 : 0);
        return static_cast<int>(lines_.points.size()) - 1;
    }

    /// The edge of a cell at a place; empty if there is none.
    [[nodiscard]] std::optional<Edge> edge_at(Point place) const {
        for (const Edge& e : cells_.edges) {
            const Point foot = at(e[0]) + nearest_fraction(place, at(e[0]), at(e[1])) * (at(e[1]) - at(e[0]));
            if (squared_length(place - foot) < tolerance_ * tolerance_) return e;
        }
        return std::nullopt;
    }

    bool try_move(int p, Point goal) {
        const Point before = at(p);
        lines_.points[index(p)] = goal;
        const auto& around = cells_at_[index(p)];
        const bool is_possible =
            std::all_of(around.begin(), around.end(), [&](std::size_t cell) { return is_sound(loop(cell)); });
        if (!is_possible) lines_.points[index(p)] = before;
        return is_possible;
    }
    [[nodiscard]] std::vector<Point> loop(std::size_t cell) const {
        std::vector<Point> corners;
        for (const int p : cells_.loop(cell)) corners.push_back(at(p));
        return corners;
    }

    /// The side of a prescribed edge that ends at a point of walls; empty unless it is the only one.
    [[nodiscard]] std::optional<std::size_t> only_side_at(int wall_point) const {
        std::optional<std::size_t> only;
        for (std::size_t i = 0; i < walls_.sides.size(); ++i) {
            if (walls_.sides[i].from != wall_point && walls_.sides[i].to != wall_point) continue;
            if (only || walls_.sides[i].part >= 0) return std::nullopt;
            only = i;
        }
        return only;
    }

    /// Adds a point for each corner and end of walls, unless a point of cells lies there.
    void add_corners() {
        for (std::size_t w = 0; w < walls_.points.size(); ++w) {
            const Point corner = walls_.points[w];
            int p = 0;
            while (p < static_cast<int>(cells_.points.size()) && length(at(p) - corner) >= tolerance_) ++p;
            if (p == static_cast<int>(cells_.points.size())) {
                p = add_point(corner, true);
                if (const auto edge = edge_at(corner)) {
                    stops_of_edge_[*edge].emplace_back(nearest_fraction(corner, at((*edge)[0]), at((*edge)[1])), p);
                } else {
                    is_inside_cell_.push_back(static_cast<int>(w));
                }
            }
            lines_.is_fixed[index(p)] = 1;
            number_.push_back(p);
        }
        for (std::size_t side = 0; side < walls_.sides.size(); ++side) {
            stops_of_wall_[side] = {{0, number_[index(walls_.sides[side].from)]}, {1, number_[index(walls_.sides[side].to)]}};
        }
    }

    /// Moves free points near a wall perpendicularly onto it.
    void snap_to_walls() {
        for (int p = 0; p < static_cast<int>(cells_.points.size()); ++p) {
            if (!is_free(p)) continue;
            double least = std::numeric_limits<double>::infinity();
            double there = 0;
            std::size_t nearest = 0;
            for (std::size_t side = first_wall(); side < walls_.sides.size(); ++side) {
                const double fraction = nearest_fraction(at(p), from_of(side), to_of(side));
                const double distance = length(at(p) - from_of(side) - fraction * (to_of(side) - from_of(side)));
                if (distance < least) std::tie(least, there, nearest) = std::tuple(distance, fraction, side);
            }
            const bool is_beside_end = there <= beside_an_end || there >= 1 - beside_an_end;
            if (least > reach_of_lines * size_at(at(p)) || is_beside_end) continue;
            if (!try_move(p, from_of(nearest) + there * (to_of(nearest) - from_of(nearest)))) continue;
            stops_of_wall_[nearest].emplace_back(there, p);
        }
    }
    [[nodiscard]] Point from_of(std::size_t side) const { return walls_.at(walls_.sides[side].from); }
    [[nodiscard]] Point to_of(std::size_t side) const { return walls_.at(walls_.sides[side].to); }

    /// The fractions of two lines at which they cross; empty if they do not.
    static std::optional<std::pair<double, double>> crossing(Point a, Point b, Point c, Point d) {
        const double start = cross(b - a, c - a);
        const double end = cross(b - a, d - a);
        if ((start > 0) == (end > 0)) return std::nullopt;
        const double on_other = start / (start - end);
        const double on_one = dot(c + on_other * (d - c) - a, b - a) / squared_length(b - a);
        if (on_one < 0 || on_one > 1) return std::nullopt;
        return std::pair(on_one, on_other);
    }

    /// Divides a wall and an edge of cells where they cross, unless an end of one lies on the other.
    void meet(std::size_t side, const Edge& edge) {
        const auto is_stop = [](const std::vector<Stop>& stops, int p) {
            return std::any_of(stops.begin(), stops.end(), [p](const Stop& stop) { return stop.second == p; });
        };
        std::vector<Stop>& on_wall = stops_of_wall_[side];
        if (is_stop(on_wall, edge[0]) || is_stop(on_wall, edge[1])) return;
        const auto known = stops_of_edge_.find(edge);
        if (known != stops_of_edge_.end()) {
            if (is_stop(known->second, on_wall[0].second) || is_stop(known->second, on_wall[1].second)) return;
        }
        const auto met = crossing(from_of(side), to_of(side), at(edge[0]), at(edge[1]));
        if (!met) return;
        const int added = add_point(from_of(side) + met->first * (to_of(side) - from_of(side)), false);
        on_wall.emplace_back(met->first, added);
        stops_of_edge_[edge].emplace_back(met->second, added);
    }

    /// Extends a wall that ends inside a cell to the side of that cell, or to an earlier wall.
    void extend(int wall_point) {
        const auto side = only_side_at(wall_point);
        if (!side || std::find(is_inside_cell_.begin(), is_inside_cell_.end(), wall_point) == is_inside_cell_.end()) return;
        const Point end = walls_.at(wall_point);
        const bool is_from = walls_.sides[*side].from == wall_point;
        const Point along = end - (is_from ? to_of(*side) : from_of(*side));
        double least = std::numeric_limits<double>::infinity();
        std::vector<Stop>* stops = nullptr;
        double fraction = 0;
        const auto try_line = [&](Point p, Point q, const auto& stops_of) {
            const double a = cross(along, p - end);
            const double b = cross(along, q - end);
            if ((a > 0) == (b > 0)) return;
            const double there = a / (a - b);
            const double distance = dot(p + there * (q - p) - end, along);
            if (distance <= 0 || distance >= least) return;
            least = distance;
            fraction = there;
            stops = &stops_of();
        };
        for (const Edge& e : cells_.edges) {
            try_line(at(e[0]), at(e[1]), [&]() -> std::vector<Stop>& { return stops_of_edge_[e]; });
        }
        for (std::size_t other = first_wall(); other < walls_.sides.size(); ++other) {
            const auto& ends = stops_of_wall_[other];
            if (other == *side || ends[0].second == number_[index(wall_point)] || ends[1].second == number_[index(wall_point)]) {
                continue;
            }
            try_line(from_of(other), to_of(other), [&]() -> std::vector<Stop>& { return stops_of_wall_[other]; });
        }
        if (stops == nullptr) return;
        const int added = add_point(end + (least / squared_length(along)) * along, false);
        stops->emplace_back(fraction, added);
        lines_.side_of[edge_between(number_[index(wall_point)], added)] = CellLines::extension;
    }

    void divide_edges() {
        std::map<Edge, std::vector<int>> line_of;  // [line] points from its first to its last
        for (const Edge& e : cells_.edges) {
            std::vector<int>& line = line_of[e];
            line = {e[0]};
            auto& stops = stops_of_edge_[e];
            std::sort(stops.begin(), stops.end());
            for (const auto& [fraction, p] : stops) line.push_back(p);
            line.push_back(e[1]);
            const auto outer = hull_side_.find(e);
            for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                const Edge piece = edge_between(line[i], line[i + 1]);
                lines_.side_of[piece] = outer == hull_side_.end() ? CellLines::no_wall : outer->second;
                if (outer != hull_side_.end()) lines_.hull.push_back(piece);
            }
        }
        for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
            const auto loop = cells_.loop(cell);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const int p = loop[k];
                const int q = loop[(k + 1) % loop.size()];
                std::vector<int> line = line_of.at(edge_between(p, q));
                if (line.front() != p) std::reverse(line.begin(), line.end());
                for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                    lines_.cell_left[{line[i], line[i + 1]}] = static_cast<int>(cell);
                }
            }
        }
    }

    void divide_walls() {
        for (std::size_t side = first_wall(); side < walls_.sides.size(); ++side) {
            auto& stops = stops_of_wall_[side];
            std::sort(stops.begin(), stops.end());
            for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
                lines_.side_of[edge_between(stops[i].second, stops[i + 1].second)] = static_cast<int>(side);
            }
        }
    }

    const PlaneCells& cells_;
    const Walls& walls_;
    double mean_size_;
    const SizeField& graded_;
    double tolerance_ = 0;
    CellLines lines_;
    std::vector<char> is_outer_;  ///< true for points of cells on the hull
    std::vector<std::vector<std::size_t>> cells_at_;
    std::map<Edge, int> hull_side_;
    std::vector<int> number_;          ///< [points of walls] numbers in the lines
    std::vector<int> is_inside_cell_;  ///< points of walls inside cells
    std::vector<std::vector<Stop>> stops_of_wall_;
    std::map<Edge, std::vector<Stop>> stops_of_edge_;
};

}  // namespace

CellLines cell_lines(const PlaneCells& cells, const Walls& walls, double mean_size, const SizeField& size) {
    return LineMaker(cells, walls, mean_size, size).run();
}

}  // namespace graincrack::mesher
