#include "mesher/plane/refined_triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

/// Longest side over the requested one. Chosen by trial: sides below it have about the requested mean.
constexpr double longest_side = 1.5;
constexpr double triangles_across = 3;  ///< across a circle

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// A vertex has its number, or −1 if it was added; a face has its region.
using MeshVertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel, CGAL::Delaunay_mesh_vertex_base_2<Kernel>>;
using MeshFace = CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using MeshTriangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<MeshVertex, MeshFace>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<MeshTriangulation>;
using Mesher = CGAL::Delaunay_mesher_2<MeshTriangulation, Criteria>;
using MeshVertexHandle = MeshTriangulation::Vertex_handle;
using MeshFaceHandle = MeshTriangulation::Face_handle;

constexpr int outside = -1;
constexpr int unknown = -2;
constexpr const char* crossing = "borders of regions cross or touch each other";

std::vector<MeshVertexHandle> insert(MeshTriangulation& triangulation, std::span<const Point> points,
                                     std::span<const RegionEdge> borders) {
    std::vector<MeshVertexHandle> vertices(points.size());
    MeshFaceHandle hint;
    for (const int i : hilbert_order(points)) {
        const auto p = index(i);
        vertices[p] = triangulation.insert({points[p].x, points[p].y}, hint);
        vertices[p]->info() = i;
        hint = vertices[p]->face();
    }
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (vertices[p]->info() != static_cast<int>(p)) throw UsageError(crossing);  // two points at one place
    }
    try {
        for (const RegionEdge& e : borders) triangulation.insert_constraint(vertices[index(e.from)], vertices[index(e.to)]);
    } catch (const MeshTriangulation::Intersection_of_constraints_exception&) {
        throw UsageError(crossing);
    }
    return vertices;
}

/// Spreads the regions of some faces to all faces that no border separates from them.
void flood(MeshTriangulation& triangulation, const std::vector<std::pair<MeshFaceHandle, int>>& known) {
    for (const auto face : triangulation.all_face_handles()) face->info() = unknown;
    std::vector<MeshFaceHandle> reached;
    for (const auto& [start, region] : known) {
        if (start->info() == region) continue;
        if (start->info() != unknown) throw UsageError(crossing);
        start->info() = region;
        reached.assign(1, start);
        while (!reached.empty()) {
            const auto face = reached.back();
            reached.pop_back();
            for (int i = 0; i < 3; ++i) {
                const auto next = face->neighbor(i);
                if (face->is_constrained(i) || next->info() == region) continue;
                next->info() = region;
                reached.push_back(next);
            }
        }
    }
}

/// The faces on both sides of the borders, with their regions.
std::vector<std::pair<MeshFaceHandle, int>> sides(const MeshTriangulation& triangulation,
                                                  const std::vector<MeshVertexHandle>& vertices,
                                                  std::span<const RegionEdge> borders) {
    std::vector<std::pair<MeshFaceHandle, int>> known{{triangulation.infinite_face(), outside}};
    for (const RegionEdge& e : borders) {
        MeshFaceHandle face;
        int i = 0;
        const auto from = vertices[index(e.from)];
        const auto to = vertices[index(e.to)];
        if (!triangulation.is_edge(from, to, face, i)) throw UsageError(crossing);
        const MeshFaceHandle other = face->neighbor(i);
        const bool is_left = face->vertex(MeshTriangulation::ccw(i)) == from;
        known.emplace_back(face, is_left ? e.left : e.right);
        known.emplace_back(other, is_left ? e.right : e.left);
    }
    return known;
}

Kernel::Point_2 centroid(MeshFaceHandle face) {
    return CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
}

void refine(MeshTriangulation& triangulation, const Refinement& refinement) {
    const double sine = std::sin(refinement.smallest_angle * std::numbers::pi / 180);
    Mesher mesher(triangulation, Criteria(sine * sine, longest_side * refinement.side));
    // Faces with a region are refined.
    for (const auto face : triangulation.all_face_handles()) face->set_in_domain(face->info() >= 0);
    mesher.init(true);
    while (!mesher.is_refinement_done()) {
        if (triangulation.number_of_vertices() > refinement.most_points) {
            throw UsageError(fmt::format("more than {} points are needed", refinement.most_points));
        }
        mesher.try_one_step_refine_mesh();
    }
}

}  // namespace

double side_for_area(double mean_area) { return std::sqrt(4 / std::numbers::pi * mean_area) / triangles_across; }

RefinedMesh refined_triangles(std::span<const Point> points, std::span<const RegionEdge> borders, const Refinement& refinement) {
    MeshTriangulation triangulation;
    const std::vector<MeshVertexHandle> vertices = insert(triangulation, points, borders);
    flood(triangulation, sides(triangulation, vertices, borders));
    const MeshTriangulation coarse = triangulation;  // its faces have their regions
    refine(triangulation, refinement);

    RefinedMesh mesh;
    mesh.points.assign(points.begin(), points.end());
    for (const auto vertex : triangulation.finite_vertex_handles()) vertex->info() = unknown;
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i]->info() = static_cast<int>(i);
    for (const auto vertex : triangulation.finite_vertex_handles()) {
        if (vertex->info() != unknown) continue;
        vertex->info() = static_cast<int>(mesh.points.size());
        mesh.points.push_back({vertex->point().x(), vertex->point().y()});
    }
    MeshFaceHandle hint;
    for (const auto face : triangulation.finite_face_handles()) {
        hint = coarse.locate(centroid(face), hint);
        if (hint->info() < 0) continue;
        mesh.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
        mesh.region_of_triangle.push_back(hint->info());
    }
    return mesh;
}

}  // namespace graincrack::mesher
