#include "mesher/plane/constrained_triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
/// Of a constrained triangulation each face knows whether it is visited, and whether it lies inside.
enum class Place { unknown, outside, inside };
using Face = CGAL::Triangulation_face_base_with_info_2<Place, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;

Edge ascending(int p, int q) { return {std::min(p, q), std::max(p, q)}; }

/// Marks the faces by a flood fill from outside, which changes sides at each loop.
void mark_places(Constrained& triangulation, std::span<const Edge> loops) {
    std::vector<Edge> borders;
    for (const Edge& e : loops) borders.push_back(ascending(e[0], e[1]));
    std::sort(borders.begin(), borders.end());
    for (const auto face : triangulation.all_face_handles()) face->info() = Place::unknown;
    std::vector<Constrained::Face_handle> reached{triangulation.infinite_face()};
    reached.front()->info() = Place::outside;
    while (!reached.empty()) {
        const auto face = reached.back();
        reached.pop_back();
        for (int i = 0; i < 3; ++i) {
            const auto next = face->neighbor(i);
            if (next->info() != Place::unknown) continue;
            const bool crosses =
                face->is_constrained(i) && std::binary_search(borders.begin(), borders.end(),
                                                              ascending(face->vertex(Constrained::cw(i))->info(),
                                                                        face->vertex(Constrained::ccw(i))->info()));
            next->info() = crosses == (face->info() == Place::outside) ? Place::inside : Place::outside;
            reached.push_back(next);
        }
    }
}

}  // namespace

std::vector<Triangle> constrained_triangles(std::span<const Point> points, std::span<const Edge> loops,
                                            std::span<const Edge> inner) {
    Constrained triangulation;
    std::vector<Constrained::Vertex_handle> vertices(points.size());
    Constrained::Face_handle hint;
    for (std::size_t i = 0; i < points.size(); ++i) {
        vertices[i] = triangulation.insert({points[i].x, points[i].y}, hint);
        vertices[i]->info() = static_cast<int>(i);
        hint = vertices[i]->face();
    }
    constexpr const char* crossing =
        "edges of the region cross or touch each other; move holes and flaws apart, or give smaller grains";
    try {
        for (const auto& edges : {loops, inner}) {
            for (const Edge& e : edges) {
                const auto from = vertices[static_cast<std::size_t>(e[0])];
                const auto to = vertices[static_cast<std::size_t>(e[1])];
                if (from == to) throw UsageError(crossing);  // two points at one place
                triangulation.insert_constraint(from, to);
            }
        }
    } catch (const Constrained::Intersection_of_constraints_exception&) {
        throw UsageError(crossing);
    }
    mark_places(triangulation, loops);
    std::vector<Triangle> triangles;
    for (const auto face : triangulation.finite_face_handles()) {
        if (face->info() != Place::inside) continue;
        triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    return triangles;
}

bool is_convex(std::span<const Point> loop) {
    const auto at = [&](std::size_t i) { return Kernel::Point_2(loop[i % loop.size()].x, loop[i % loop.size()].y); };
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (CGAL::orientation(at(i), at(i + 1), at(i + 2)) == CGAL::RIGHT_TURN) return false;
    }
    return true;
}

}  // namespace graincrack::mesher
