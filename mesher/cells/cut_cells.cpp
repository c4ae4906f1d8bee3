#include "mesher/cells/cut_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mesher/cells/cell_pieces.hpp"
#include "mesher/cells/joined_pieces.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/cells/snapped_corners.hpp"

namespace graincrack::mesher {

namespace {

/// Divides the piece in which a path from one of its points to another lies; a path along its side is marked only.
bool split_piece(CellPieces& pieces, const std::vector<std::pair<int, int>>& path) {
    const int u = path.front().first;
    const int v = path.back().first;
    const auto mark_path = [&] {
        for (std::size_t i = 1; i < path.size(); ++i) {
            // An extension that is there gives way to a wall, and no wall to an extension.
            if (path[i].second < 0 && pieces.mark_of(path[i - 1].first, path[i].first) >= 0) continue;
            pieces.mark(path[i - 1].first, path[i].first, path[i].second);
        }
    };
    const Point middle = midpoint(pieces.at(u), pieces.at(path[1].first));
    for (const int number : std::vector<int>(pieces.pieces_at(u))) {
        const auto piece = static_cast<std::size_t>(number);
        PieceLoop loop = pieces.loop(piece);
        const auto start = std::find(loop.begin(), loop.end(), u);
        std::rotate(loop.begin(), start, loop.end());
        const auto end = std::find(loop.begin(), loop.end(), v);
        if (end == loop.end()) continue;
        if (path.size() == 2 && (loop[1] == v || loop.back() == v)) {
            mark_path();
            return true;
        }
        if (!pieces.is_inside(loop, middle)) continue;
        PieceLoop right(loop.begin(), end + 1);
        PieceLoop left(end, loop.end());
        left.push_back(u);
        for (std::size_t i = path.size() - 2; i > 0; --i) right.push_back(path[i].first);
        for (std::size_t i = 1; i + 1 < path.size(); ++i) left.push_back(path[i].first);
        if (!(area_of(pieces.corners(left)) > 0) || !(area_of(pieces.corners(right)) > 0)) return false;
        pieces.set_loop(piece, std::move(left));
        pieces.add_piece(std::move(right), pieces.origin(piece));
        mark_path();
        return true;
    }
    return false;
}

/// Cuts pieces along a chain. \return whether they have room
bool cut_along(CellPieces& pieces, WallChain chain, Point& no_room) {
    no_room = midpoint(chain.points.front(), chain.points[1]);
    const ChainNodes nodes = snapped_corners(pieces, chain);
    if (nodes.size() < 2) return false;
    const auto n = static_cast<double>(chain.sides.size());
    for (std::size_t i = 0; i + (chain.is_closed ? 0 : 1) < nodes.size(); ++i) {
        const auto [from, u] = nodes[i];
        auto [to, v] = nodes[(i + 1) % nodes.size()];
        if (i + 1 == nodes.size()) to += n;
        std::vector<std::pair<int, int>> path{{u, 0}};  // points, and the sides that lead to them
        const auto side_at = [&](double t) { return chain.sides[static_cast<std::size_t>(t) % chain.sides.size()]; };
        for (double k = std::floor(from) + 1; k < to; ++k) {
            const auto corner = static_cast<std::size_t>(k) % chain.sides.size();
            const int added = pieces.add_point(chain.points[corner]);
            pieces.fix(added);
            path.emplace_back(added, side_at(k - 0.5));
        }
        path.emplace_back(v, side_at(std::max(from, std::ceil(to) - 1)));
        if (split_piece(pieces, path)) continue;
        no_room = midpoint(pieces.at(path[0].first), pieces.at(path[1].first));
        return false;
    }
    return true;
}

/// The pieces that are left, fixed points first.
CutCells cells_of(const CellPieces& pieces, const std::vector<double>& areas) {
    const auto index = [](int i) { return static_cast<std::size_t>(i); };
    CutCells made;
    std::vector<int> number(pieces.n_points(), -1);
    for (const bool fixed : {true, false}) {
        for (int p = 0; p < static_cast<int>(pieces.n_points()); ++p) {
            if (pieces.pieces_at(p).empty() || pieces.is_fixed(p) != fixed) continue;
            number[index(p)] = static_cast<int>(made.cells.points.size());
            made.cells.points.push_back(pieces.at(p));
        }
        if (fixed) made.n_fixed = made.cells.points.size();
    }
    std::vector<std::pair<int, Side>> walls;
    for (std::size_t cell = 0; cell < pieces.size(); ++cell) {
        const PieceLoop& loop = pieces.loop(cell);
        if (loop.empty()) continue;
        made.areas.push_back(areas[cell]);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int p = loop[i];
            const int q = loop[(i + 1) % loop.size()];
            const Edge edge = edge_between(number[index(p)], number[index(q)]);
            made.cells.corners.push_back(number[index(p)]);
            made.cells.edges.push_back(edge);
            const int side = pieces.mark_of(p, q);
            if (side < 0) continue;
            const Side& wall = pieces.side(side);
            if (wall.part >= 0) {
                walls.push_back({side, {number[index(p)], number[index(q)], wall.part, {}}});
            } else if (pieces.is_of_walls(side) && edge[0] == number[index(p)]) {
                walls.push_back({side, {edge[0], edge[1], -1, wall.kind}});
            }
        }
        made.cells.start.push_back(static_cast<int>(made.cells.corners.size()));
    }
    std::sort(made.cells.edges.begin(), made.cells.edges.end());
    made.cells.edges.erase(std::unique(made.cells.edges.begin(), made.cells.edges.end()), made.cells.edges.end());
    std::stable_sort(walls.begin(), walls.end(), [](const auto& a, const auto& b) {
        return std::pair(a.second.part < 0, a.first) < std::pair(b.second.part < 0, b.first);
    });
    for (const auto& [side, wall] : walls) made.cells.sides.push_back(wall);
    return made;
}

}  // namespace

std::optional<CutCells> cut_cells(const PlaneCells& cells, std::span<const Point> seeds, const std::vector<double>& areas,
                                  const Walls& walls, const SizeField& size, Point* no_room) {
    const double mean_area = std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size());
    CellPieces pieces(cells, walls, std::sqrt(mean_area), size);
    Point place;
    Point& without_room = no_room == nullptr ? place : *no_room;
    for (const WallChain& chain : walls.chains()) {
        if (!cut_along(pieces, chain, without_room)) return std::nullopt;
    }
    const auto wanted = joined_pieces(pieces, seeds, areas, without_room);
    if (!wanted) return std::nullopt;
    return cells_of(pieces, *wanted);
}

}  // namespace graincrack::mesher
