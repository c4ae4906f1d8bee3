// Polygonal cells that are cut into pieces and joined again: their points, loops and edges along walls.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/walls.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Points around a piece, counter-clockwise.
using PieceLoop = std::vector<int>;

/// Cells and the pieces into which they are cut. Pieces that are gone have an empty loop.
class CellPieces {
public:
    static constexpr int no_wall = -1;
    static constexpr int extension = -2;  ///< of a wall to the side of the cell in which it ends

    /// \param cells of the hull of the walls \param mean_size root of the mean area of cells \param size graded, over it
    CellPieces(const PlaneCells& cells, const Walls& walls, double mean_size, const SizeField& size);

    [[nodiscard]] std::size_t size() const { return loops_.size(); }
    [[nodiscard]] std::size_t n_points() const { return points_.size(); }
    [[nodiscard]] Point at(int p) const { return points_[index(p)]; }
    [[nodiscard]] const PieceLoop& loop(std::size_t piece) const { return loops_[piece]; }
    [[nodiscard]] std::size_t origin(std::size_t piece) const { return origin_[piece]; }  ///< the cell of which it is
    [[nodiscard]] const std::vector<int>& pieces_at(int p) const { return pieces_of_point_[index(p)]; }
    [[nodiscard]] std::vector<Point> corners(const PieceLoop& loop) const;
    [[nodiscard]] std::vector<Point> corners(std::size_t piece) const { return corners(loops_[piece]); }
    [[nodiscard]] double area(std::size_t piece) const;
    [[nodiscard]] bool is_inside(const PieceLoop& loop, Point p) const;
    /// The point of pieces at a place, or −1.
    [[nodiscard]] int point_at(Point place) const;
    [[nodiscard]] double tolerance() const { return tolerance_; }  ///< within which two places are one, m
    /// The root of the mean area of cells at a place, and what its square is there over that of equal cells.
    [[nodiscard]] double size_at(Point p) const { return mean_size_ * graded_.graded(p); }
    [[nodiscard]] double square_of_size(Point p) const { return graded_.graded(p) * graded_.graded(p); }

    /// A fixed point stays where it is; a free one is neither fixed nor on a wall.
    void fix(int p) { is_fixed_[index(p)] = 1; }
    [[nodiscard]] bool is_fixed(int p) const { return is_fixed_[index(p)] != 0; }
    [[nodiscard]] bool is_free(int p) const { return is_fixed_[index(p)] == 0 && is_on_wall_[index(p)] == 0; }
    /// Moves a point if the pieces around it stay sound. \return whether it did
    bool try_move(int p, Point goal);

    int add_point(Point p);
    void add_piece(PieceLoop loop, std::size_t origin);
    void set_loop(std::size_t piece, PieceLoop loop);
    void set_origin(std::size_t piece, std::size_t cell) { origin_[piece] = cell; }
    /// Inserts a point in an edge.
    void split_edge(int p, int q, int middle);

    /// The side that an edge lies on: of walls, then of the hull; `extension` or `no_wall`.
    void mark(int p, int q, int side);
    [[nodiscard]] int mark_of(int p, int q) const;
    [[nodiscard]] const Side& side(int number) const { return sides_[index(number)]; }
    /// From the start to the end of a side of walls.
    [[nodiscard]] Point direction(int number) const { return walls_.at(side(number).to) - walls_.at(side(number).from); }
    [[nodiscard]] bool is_of_walls(int number) const { return index(number) < walls_.sides.size(); }

    /// Calls visit(p, q) for the edges of each piece.
    template <class Visit>
    void for_each_edge(const Visit& visit) const {
        for (const PieceLoop& loop : loops_) {
            for (std::size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[(i + 1) % loop.size()]);
        }
    }

    /// The number of a set for each piece; pieces beside an edge whose mark is no border are in one set.
    [[nodiscard]] std::vector<std::size_t> sets(const std::function<bool(int)>& is_border) const;

private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }

    const Walls& walls_;
    const SizeField& graded_;
    double mean_size_;
    double tolerance_ = 0;
    std::vector<Point> points_;
    std::vector<Side> sides_;  ///< those of the walls, then those of the hull
    std::vector<PieceLoop> loops_;
    std::vector<std::size_t> origin_;
    std::vector<std::vector<int>> pieces_of_point_;
    std::vector<char> is_fixed_;
    std::vector<char> is_on_wall_;
    std::map<Edge, int> marks_;
};

}  // namespace graincrack::mesher
