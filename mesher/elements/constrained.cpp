#include "mesher/elements/constrained.hpp"

#include <utility>

#include "mesher/plane/constrained_triangulation.hpp"

namespace graincrack::mesher {

PlaneMesh constrained_mesh(PlaneCells cells, Bodies bodies) {
    PlaneMesh mesh;
    const auto at = [&](int p) { return cells.points[static_cast<std::size_t>(p)]; };
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const auto loop = cells.loop(cell);
        std::vector<Point> corners;
        std::vector<Edge> sides;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            corners.push_back(at(loop[i]));
            sides.push_back({static_cast<int>(i), static_cast<int>((i + 1) % loop.size())});
        }
        const auto add_body = [&](std::span<const int> points) {
            mesh.body_points.insert(mesh.body_points.end(), points.begin(), points.end());
            mesh.body_start.push_back(static_cast<int>(mesh.body_points.size()));
            mesh.crystal_of_body.push_back(static_cast<int>(cell));
            mesh.area_of_body.push_back(0);
        };
        if (bodies == Bodies::cells) add_body(loop);
        for (const Triangle& t : constrained_triangles(corners, sides)) {
            Triangle triangle;
            for (std::size_t k = 0; k < 3; ++k) triangle[k] = loop[static_cast<std::size_t>(t[k])];
            if (bodies == Bodies::triangles) add_body(triangle);
            mesh.triangles.push_back(triangle);
            mesh.body_of_triangle.push_back(static_cast<int>(mesh.n_bodies()) - 1);
            mesh.area_of_body.back() += signed_area(at(triangle[0]), at(triangle[1]), at(triangle[2]));
        }
    }
    mesh.points = std::move(cells.points);
    mesh.sides = std::move(cells.sides);
    return mesh;
}

}  // namespace graincrack::mesher
