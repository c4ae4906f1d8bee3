#include "mesher/cells/cut_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "mesher/cells/cell_lines.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/plane/triangulation.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

using PieceLoop = std::vector<int>;

/// A part of a cell between lines; it consists of triangles.
struct Piece {
    std::vector<std::size_t> triangles;
    std::size_t cell = 0;  ///< the cell that has it, or the largest part of it
    double area = 0;
    double fraction = 0;  ///< its area over the requested area of its cell, summed over joined pieces
};

class PieceJoiner {
public:
    PieceJoiner(const CellLines& lines, const Zones& zones) : lines_(lines), zones_(zones) {
        std::vector<Edge> inner;
        for (const auto& [edge, side] : lines.side_of) inner.push_back(edge);
        triangles_ = constrained_triangles(lines.points, lines.hull, inner);
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) triangle_left_[side_of_triangle(t, k)] = t;
        }
        find_pieces();
    }

    /// Joins the pieces of a zone until their number is that of the areas, and gives each piece one of the areas.
    /// \param areas requested areas over the squares of the graded sizes at their places
    /// \return true if all have room; else `no_room` is a place in a piece that has none
    bool join(std::size_t zone, std::vector<double> areas, const std::vector<double>& area_of_cell, const SizeField& size,
              Point& no_room) {
        std::vector<std::size_t> left;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (zone_of_[i] != zone) continue;
            pieces_[i].fraction = pieces_[i].area / area_of_cell[pieces_[i].cell];
            left.push_back(i);
        }
        while (left.size() > areas.size()) {
            std::sort(left.begin(), left.end(),
                      [&](std::size_t a, std::size_t b) { return pieces_[a].fraction < pieces_[b].fraction; });
            const auto joined =
                std::find_if(left.begin(), left.end(), [&](std::size_t piece) { return join_to_neighbour(piece); });
            if (joined == left.end()) break;
            left.erase(joined);
        }
        no_room = left.empty() ? Point{} : middle_of(left.front());
        if (left.empty() || left.size() != areas.size()) return false;
        // The largest area goes to the largest piece, over the squares of their graded sizes.
        const auto square_at = [&](std::size_t piece) { return std::pow(size.graded(middle_of(piece)), 2); };
        std::sort(areas.begin(), areas.end());
        std::sort(left.begin(), left.end(),
                  [&](std::size_t a, std::size_t b) { return pieces_[a].area / square_at(a) < pieces_[b].area / square_at(b); });
        double present = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            present += pieces_[left[i]].area;
            areas[i] *= square_at(left[i]);
        }
        const double scale = present / std::accumulate(areas.begin(), areas.end(), 0.0);
        for (std::size_t i = 0; i < left.size(); ++i) {
            no_room = middle_of(left[i]);
            std::optional<PieceLoop> loop = outline(pieces_[left[i]].triangles);
            if (!loop) return false;
            kept_.push_back({std::move(*loop), scale * areas[i]});
        }
        return true;
    }

    /// Returns the pieces that are left as cells, with fixed points first.
    [[nodiscard]] CutCells cells() {
        drop_kinks();
        CutCells made;
        std::vector<char> is_used(lines_.points.size(), 0);
        for (const auto& [loop, area] : kept_) {
            for (const int p : loop) is_used[index(p)] = 1;
        }
        std::vector<int> number(lines_.points.size(), -1);
        for (const bool fixed : {true, false}) {
            for (std::size_t p = 0; p < number.size(); ++p) {
                if (is_used[p] == 0 || (lines_.is_fixed[p] != 0) != fixed) continue;
                number[p] = static_cast<int>(made.cells.points.size());
                made.cells.points.push_back(lines_.points[p]);
            }
            if (fixed) made.n_fixed = made.cells.points.size();
        }
        std::vector<std::pair<int, Side>> sides;
        for (const auto& [loop, area] : kept_) {
            made.areas.push_back(area);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int p = loop[i];
                const int q = loop[(i + 1) % loop.size()];
                const int from = number[index(p)];
                const int to = number[index(q)];
                made.cells.corners.push_back(from);
                made.cells.edges.push_back(edge_between(from, to));
                const int side = line(p, q);
                if (side < 0) continue;
                const Side& wall = lines_.sides[index(side)];
                if (wall.part >= 0) sides.push_back({side, {from, to, wall.part, {}}});
                if (wall.part < 0 && from < to) sides.push_back({side, {from, to, -1, wall.kind}});
            }
            made.cells.start.push_back(static_cast<int>(made.cells.corners.size()));
        }
        std::sort(made.cells.edges.begin(), made.cells.edges.end());
        made.cells.edges.erase(std::unique(made.cells.edges.begin(), made.cells.edges.end()), made.cells.edges.end());
        std::stable_sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) {
            return std::pair(a.second.part < 0, a.first) < std::pair(b.second.part < 0, b.first);
        });
        for (const auto& [number_of_side, side] : sides) made.cells.sides.push_back(side);
        return made;
    }

private:
    [[nodiscard]] Point at(int p) const { return lines_.points[index(p)]; }
    [[nodiscard]] Edge side_of_triangle(std::size_t t, std::size_t k) const {
        return {triangles_[t][k], triangles_[t][(k + 1) % 3]};
    }
    [[nodiscard]] double area_of_triangle(std::size_t t) const {
        return signed_area(at(triangles_[t][0]), at(triangles_[t][1]), at(triangles_[t][2]));
    }
    [[nodiscard]] Point middle_of(std::size_t piece) const {
        const auto& own = pieces_[piece].triangles;
        const std::size_t t = *std::max_element(
            own.begin(), own.end(), [&](std::size_t a, std::size_t b) { return area_of_triangle(a) < area_of_triangle(b); });
        return (1.0 / 3) * (at(triangles_[t][0]) + at(triangles_[t][1]) + at(triangles_[t][2]));
    }
    /// Number of the side on which an edge lies, else `CellLines::extension` or `CellLines::no_wall`.
    [[nodiscard]] int line(int p, int q) const {
        const auto found = lines_.side_of.find(edge_between(p, q));
        return found == lines_.side_of.end() ? CellLines::no_wall : found->second;
    }

    void find_pieces() {
        constexpr std::size_t none = static_cast<std::size_t>(-1);
        piece_of_.assign(triangles_.size(), none);
        for (std::size_t start = 0; start < triangles_.size(); ++start) {
            if (piece_of_[start] != none) continue;
            Piece piece;
            piece_of_[start] = pieces_.size();
            piece.triangles = {start};
            for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
                const std::size_t t = piece.triangles[i];
                piece.area += area_of_triangle(t);
                for (std::size_t k = 0; k < 3; ++k) {
                    const Edge side = side_of_triangle(t, k);
                    if (const auto cell = lines_.cell_left.find(side); cell != lines_.cell_left.end()) {
                        piece.cell = index(cell->second);
                    }
                    const auto next = triangle_left_.find({side[1], side[0]});
                    if (lines_.side_of.contains(edge_between(side[0], side[1])) || next == triangle_left_.end()) continue;
                    if (piece_of_[next->second] != none) continue;
                    piece_of_[next->second] = pieces_.size();
                    piece.triangles.push_back(next->second);
                }
            }
            pieces_.push_back(std::move(piece));
            zone_of_.push_back(zones_.zone_at(middle_of(pieces_.size() - 1)));
        }
    }

    /// Returns the loop around triangles; empty if it meets itself. Walls and extensions that end within belong to the loop.
    [[nodiscard]] std::optional<PieceLoop> outline(const std::vector<std::size_t>& triangles) const {
        std::map<int, int> next;
        std::size_t n = 0;
        for (const std::size_t t : triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Edge side = side_of_triangle(t, k);
                const auto other = triangle_left_.find({side[1], side[0]});
                const bool is_inner = other != triangle_left_.end() && line(side[0], side[1]) == CellLines::no_wall &&
                                      std::find(triangles.begin(), triangles.end(), other->second) != triangles.end();
                if (is_inner) continue;
                if (!next.emplace(side[0], side[1]).second) return std::nullopt;
                ++n;
            }
        }
        PieceLoop loop;
        for (int p = next.begin()->first; loop.empty() || p != loop.front(); p = next.at(p)) loop.push_back(p);
        return loop.size() == n ? std::optional(loop) : std::nullopt;
    }

    [[nodiscard]] std::vector<Point> corners(const PieceLoop& loop) const {
        std::vector<Point> corners;
        for (const int p : loop) corners.push_back(at(p));
        return corners;
    }

    /// Joins a piece to the neighbour with the longest common side, preferably to one with which it forms a sound polygon.
    bool join_to_neighbour(std::size_t piece) {
        std::map<std::size_t, double> common;
        for (const std::size_t t : pieces_[piece].triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Edge side = side_of_triangle(t, k);
                const auto other = triangle_left_.find({side[1], side[0]});
                if (other == triangle_left_.end() || line(side[0], side[1]) != CellLines::no_wall) continue;
                if (piece_of_[other->second] != piece) common[piece_of_[other->second]] += length(at(side[1]) - at(side[0]));
            }
        }
        std::vector<std::pair<double, std::size_t>> order;
        for (const auto& [other, size] : common) order.emplace_back(-size, other);
        std::sort(order.begin(), order.end());
        for (const bool must_be_sound : {true, false}) {
            for (const auto& [size, other] : order) {
                std::vector<std::size_t> united = pieces_[other].triangles;
                united.insert(united.end(), pieces_[piece].triangles.begin(), pieces_[piece].triangles.end());
                const std::optional<PieceLoop> loop = outline(united);
                if (!loop || (must_be_sound && !is_sound(corners(*loop)))) continue;
                Piece& whole = pieces_[other];
                for (const std::size_t t : pieces_[piece].triangles) piece_of_[t] = other;
                if (pieces_[piece].area > whole.area) whole.cell = pieces_[piece].cell;
                whole.fraction += pieces_[piece].fraction;
                whole.area += pieces_[piece].area;
                whole.triangles = std::move(united);
                return true;
            }
        }
        return false;
    }

    /// Removes points that lie within one side of cells, if these remain sound.
    void drop_kinks() {
        std::map<int, std::vector<std::size_t>> cells_at;
        for (std::size_t cell = 0; cell < kept_.size(); ++cell) {
            for (const int p : kept_[cell].first) cells_at[p].push_back(cell);
        }
        for (const auto& [p, around] : cells_at) {
            if (lines_.is_fixed[index(p)] != 0) continue;
            std::vector<Edge> ends;
            std::vector<PieceLoop> loops;
            bool fits = true;
            for (const std::size_t cell : around) {
                PieceLoop loop = kept_[cell].first;
                std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), p), loop.end());
                ends.push_back(edge_between(loop[1], loop.back()));
                loop.erase(loop.begin());
                fits = fits && ends.back() == ends.front() && loop.size() > 2 && is_sound(corners(loop));
                loops.push_back(std::move(loop));
            }
            const auto [from, to] = ends.front();
            const int side = line(from, p);
            const bool is_within = side == line(to, p) && line(from, to) == CellLines::no_wall;
            if (!fits || !is_within || (around.size() == 1 && side < 0)) continue;
            for (std::size_t k = 0; k < around.size(); ++k) kept_[around[k]].first = std::move(loops[k]);
            if (side != CellLines::no_wall) lines_.side_of[edge_between(from, to)] = side;
        }
    }

    CellLines lines_;
    const Zones& zones_;
    std::vector<Triangle> triangles_;
    std::map<Edge, std::size_t> triangle_left_;  ///< the triangle to the left of a directed edge
    std::vector<Piece> pieces_;
    std::vector<std::size_t> piece_of_;               ///< [triangles]
    std::vector<std::size_t> zone_of_;                ///< [pieces]
    std::vector<std::pair<PieceLoop, double>> kept_;  ///< cells with their requested areas
};

}  // namespace

std::optional<CutCells> cut_cells(const PlaneCells& cells, const std::vector<double>& areas, const Walls& walls,
                                  const Zones& zones, std::span<const std::size_t> zone_of_cell, const SizeField& size,
                                  Point& no_room) {
    const double mean_area = std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size());
    try {
        PieceJoiner joiner(cell_lines(cells, walls, std::sqrt(mean_area), size), zones);
        for (std::size_t zone = 0; zone < zones.size(); ++zone) {
            if (!zones.is_inside(zone)) continue;
            std::vector<double> requested;
            for (std::size_t cell = 0; cell < areas.size(); ++cell) {
                if (zone_of_cell[cell] != zone) continue;
                requested.push_back(areas[cell] / std::pow(size.graded(moments(corners_of(cells, cell)).centroid), 2));
            }
            if (!joiner.join(zone, requested, areas, size, no_room)) return std::nullopt;
        }
        return joiner.cells();
    } catch (const UsageError&) {
        no_room = walls.points.back();
        return std::nullopt;  // lines cross after points were moved
    }
}

}  // namespace graincrack::mesher
