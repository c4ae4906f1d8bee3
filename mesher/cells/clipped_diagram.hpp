// Clips a power diagram to a convex outline: areas, centroids and sides of its cells.
#pragma once

#include <span>
#include <vector>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/plane/power_diagram.hpp"

namespace graincrack::mesher {

/// The part of a power diagram within a convex outline.
class ClippedDiagram {
public:
    /// \param outline must outlive the diagram
    ClippedDiagram(const ConvexOutline& outline, std::span<const Point> seeds, std::span<const double> weights);

    /// A side that two cells share, with the cell of `left` on its left.
    struct Side {
        int left = 0, right = 0;
        Point from, to;
        int from_point = 0;  ///< number of a vertex of the diagram; −1 − number of the crossing on the outline
        int to_point = 0;
    };
    [[nodiscard]] const std::vector<Side>& sides() const { return sides_; }
    /// Areas of the cells, m²; 0 for empty cells.
    [[nodiscard]] const std::vector<double>& areas() const { return areas_; }
    /// Centroids of the cells; undefined for empty cells.
    [[nodiscard]] const std::vector<Point>& centroids() const { return centroids_; }
    /// True if each stretch of the outline has one cell. Round-off can prevent this if a vertex nearly meets the outline.
    [[nodiscard]] bool is_consistent() const { return is_consistent_; }

    /// The cells as polygons that share points. Corners of the outline come first, in order.
    [[nodiscard]] PlaneCells cells() const;

private:
    /// The point at which a side between two cells ends on the outline.
    struct Crossing {
        std::size_t outline_side;
        double share;  ///< fraction of the side of the outline
        int after;     ///< cell that follows counter-clockwise
        int before, number;
        Point at;
    };
    void clip(const PowerDiagram& diagram);
    void sum_up();
    /// Calls `visit(cell, from, to, outline side)` for the sides of cells along the outline, counter-clockwise. Points have the
    /// numbers of sides; corners of the outline are numbered by `corner_point`.
    template <class Visit>
    void for_each_outer_side(const Visit& visit) const;

    const ConvexOutline* outline_;
    std::size_t n_cells_;
    int n_vertices_ = 0;
    std::vector<Side> sides_;
    std::vector<Crossing> crossings_;  ///< counter-clockwise along the outline
    std::vector<double> areas_;
    std::vector<Point> centroids_;
    bool is_consistent_ = true;
};

}  // namespace graincrack::mesher
