#include "mesher/cells/cell_pieces.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesher/cells/polygon.hpp"

namespace graincrack::mesher {

namespace {

constexpr double same_point = 1e-9;  ///< over the extent

}  // namespace

CellPieces::CellPieces(const PlaneCells& cells, const Walls& walls, double mean_size, const SizeField& size)
    : walls_(walls), graded_(size), mean_size_(mean_size), points_(cells.points), sides_(walls.sides) {
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const auto loop = cells.loop(cell);
        add_piece({loop.begin(), loop.end()}, cell);
    }
    is_fixed_.assign(points_.size(), 0);
    is_on_wall_.assign(points_.size(), 0);
    Box box{points_.front(), points_.front()};
    for (std::size_t p = 0; p < walls.hull.size(); ++p) {
        is_fixed_[p] = 1;
        box.high = {std::max(box.high.x, points_[p].x), std::max(box.high.y, points_[p].y)};
        box.low = {std::min(box.low.x, points_[p].x), std::min(box.low.y, points_[p].y)};
    }
    tolerance_ = same_point * (box.width() + box.height());
    for (Side side : cells.sides) {
        if (!walls.is_convex) side.part = no_wall;
        mark(side.from, side.to, static_cast<int>(sides_.size()));
        sides_.push_back(side);
    }
}

std::vector<Point> CellPieces::corners(const PieceLoop& loop) const {
    std::vector<Point> result;
    for (const int p : loop) result.push_back(at(p));
    return result;
}

double CellPieces::area(std::size_t piece) const { return area_of(corners(loops_[piece])); }

bool CellPieces::is_inside(const PieceLoop& loop, Point p) const {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point a = at(loop[i]);
        const Point b = at(loop[(i + 1) % loop.size()]);
        if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

int CellPieces::point_at(Point place) const {
    for (std::size_t p = 0; p < points_.size(); ++p) {
        if (!pieces_of_point_[p].empty() && squared_length(points_[p] - place) < tolerance_ * tolerance_) {
            return static_cast<int>(p);
        }
    }
    return -1;
}

bool CellPieces::try_move(int p, Point goal) {
    const Point before = at(p);
    points_[index(p)] = goal;
    const std::vector<int>& around = pieces_of_point_[index(p)];
    const bool is_possible =
        std::all_of(around.begin(), around.end(), [&](int piece) { return is_sound(corners(loops_[index(piece)])); });
    if (!is_possible) points_[index(p)] = before;
    return is_possible;
}

int CellPieces::add_point(Point p) {
    points_.push_back(p);
    is_fixed_.push_back(0);
    is_on_wall_.push_back(0);
    pieces_of_point_.emplace_back();
    return static_cast<int>(points_.size()) - 1;
}

void CellPieces::add_piece(PieceLoop loop, std::size_t origin) {
    const int cell = static_cast<int>(loops_.size());
    pieces_of_point_.resize(points_.size());
    for (const int p : loop) pieces_of_point_[index(p)].push_back(cell);
    loops_.push_back(std::move(loop));
    origin_.push_back(origin);
}

void CellPieces::set_loop(std::size_t piece, PieceLoop loop) {
    for (const int p : loops_[piece]) std::erase(pieces_of_point_[index(p)], static_cast<int>(piece));
    for (const int p : loop) pieces_of_point_[index(p)].push_back(static_cast<int>(piece));
    loops_[piece] = std::move(loop);
}

void CellPieces::split_edge(int p, int q, int middle) {
    const std::vector<int> around = pieces_of_point_[index(p)];
    for (const int cell : around) {
        PieceLoop& loop = loops_[index(cell)];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int a = loop[i];
            const int b = loop[(i + 1) % loop.size()];
            if (edge_between(a, b) != edge_between(p, q)) continue;
            loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
            pieces_of_point_[index(middle)].push_back(cell);
            break;
        }
    }
    const int side = mark_of(p, q);
    if (side == no_wall) return;
    marks_.erase(edge_between(p, q));
    mark(p, middle, side);
    mark(middle, q, side);
}

void CellPieces::mark(int p, int q, int side) {
    marks_[edge_between(p, q)] = side;
    if (side >= 0) is_on_wall_[index(p)] = is_on_wall_[index(q)] = 1;
}

int CellPieces::mark_of(int p, int q) const {
    const auto found = marks_.find(edge_between(p, q));
    return found == marks_.end() ? no_wall : found->second;
}

std::vector<std::size_t> CellPieces::sets(const std::function<bool(int)>& is_border) const {
    std::map<Edge, std::size_t> other;
    std::vector<std::size_t> parent(loops_.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (std::size_t cell = 0; cell < loops_.size(); ++cell) {
        const PieceLoop& loop = loops_[cell];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int p = loop[i];
            const int q = loop[(i + 1) % loop.size()];
            const auto [found, is_new] = other.try_emplace(edge_between(p, q), cell);
            if (!is_new && !is_border(mark_of(p, q))) parent[root(cell)] = root(found->second);
        }
    }
    std::vector<std::size_t> sets;
    for (std::size_t cell = 0; cell < loops_.size(); ++cell) sets.push_back(root(cell));
    return sets;
}

}  // namespace graincrack::mesher
