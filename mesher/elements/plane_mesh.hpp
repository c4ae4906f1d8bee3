// A mesh of triangles inside cells; each belongs to a body, each body to a crystal.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesher/seeds/seeds.hpp"

namespace graincrack::mesher {

/// Bodies are cells, or the triangles of cells, so that crystals can break.
enum class Bodies { cells, triangles };

/// A body stays whole: in a specimen it is a grain with nodes of its own. A crystal is a cell and may consist of several bodies.
struct PlaneMesh {
    std::vector<Point> points;  ///< points, shared by adjacent bodies
    std::vector<Triangle> triangles;
    std::vector<int> body_of_triangle;  ///< ascending
    std::vector<int> crystal_of_body;
    std::vector<double> area_of_body;  ///< m²
    std::vector<int> body_points;      ///< points of all bodies, each in the order of its nodes
    std::vector<int> body_start{0};    ///< [bodies + 1] first point of each body
    std::vector<Side> sides;           ///< sides of the cells, divided like those of triangles

    [[nodiscard]] std::size_t n_bodies() const { return crystal_of_body.size(); }
    /// Computes areas and points of bodies from their triangles. Points are in the order of the triangles.
    void complete_bodies() {
        area_of_body.assign(n_bodies(), 0);
        body_points.clear();
        body_start.clear();
        std::vector<int> body_with(points.size(), -1);  // [point] last body that has it
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const int body = body_of_triangle[t];
            if (body == static_cast<int>(body_start.size())) body_start.push_back(static_cast<int>(body_points.size()));
            for (const int p : triangles[t]) {
                if (std::exchange(body_with[index(p)], body) != body) body_points.push_back(p);
            }
            const auto at = [&](std::size_t k) { return points[index(triangles[t][k])]; };
            area_of_body[index(body)] += signed_area(at(0), at(1), at(2));
        }
        body_start.push_back(static_cast<int>(body_points.size()));
    }
};

}  // namespace graincrack::mesher
