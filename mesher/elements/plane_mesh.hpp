// Triangles inside cells, each of a body, each body of a crystal.
#pragma once

#include <vector>

#include "mesher/seeds/seeds.hpp"

namespace graincrack::mesher {

/// What becomes a body: each cell, or each triangle of it, so that crystals can break.
enum class Bodies { cells, triangles };

/// A body is what stays whole: in a specimen a grain with nodes of its own. A crystal is a cell; it may consist of several
/// bodies.
struct PlaneMesh {
    std::vector<Point> points;  ///< shared by the bodies that meet there
    std::vector<Triangle> triangles;
    std::vector<int> body_of_triangle;  ///< ascending
    std::vector<int> crystal_of_body;
    std::vector<double> area_of_body;  ///< m²
    std::vector<int> body_points;      ///< points of all bodies, each in the order of its nodes
    std::vector<int> body_start{0};    ///< [bodies + 1] first point of each body
    std::vector<Side> sides;           ///< as of the cells, in the pieces that triangles have

    [[nodiscard]] std::size_t n_bodies() const { return crystal_of_body.size(); }
};

}  // namespace graincrack::mesher
