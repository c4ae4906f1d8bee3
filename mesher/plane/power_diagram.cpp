#include "mesher/plane/power_diagram.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// A vertex has its seed, or −1 for a helper; a face has the dual vertex of the diagram.
using PowerVertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel, CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
using PowerFace = CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Regular_triangulation_face_base_2<Kernel>>;
using Regular = CGAL::Regular_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<PowerVertex, PowerFace>>;
using PowerFaceHandle = Regular::Face_handle;

constexpr int helper = -1;
/// Distance over the reach at which three helpers of the least weight have no part of the circle, and enclose all seeds.
constexpr double helper_distance = 8;

/// The point with equal powers to the three corners of a face.
Point power_centre(PowerFaceHandle face) {
    const auto at = [&](int i) { return Point{face->vertex(i)->point().x(), face->vertex(i)->point().y()}; };
    const auto weight = [&](int i) { return face->vertex(i)->point().weight(); };
    const Point u = at(1) - at(0);
    const Point v = at(2) - at(0);
    const double along_u = 0.5 * (squared_length(u) - weight(1) + weight(0));
    const double along_v = 0.5 * (squared_length(v) - weight(2) + weight(0));
    const double determinant = cross(u, v);
    return at(0) + Point{(along_u * v.y - along_v * u.y) / determinant, (along_v * u.x - along_u * v.x) / determinant};
}

}  // namespace

PowerDiagram power_diagram(std::span<const Point> seeds, std::span<const double> weights, double reach) {
    Regular triangulation;
    PowerFaceHandle hint;
    const auto insert = [&](Point p, double weight, int number) {
        const auto vertex = triangulation.insert(Regular::Weighted_point(Kernel::Point_2(p.x, p.y), weight), hint);
        vertex->info() = number;
        hint = vertex->face();
    };
    const double least = *std::min_element(weights.begin(), weights.end());
    const double far = helper_distance * reach;
    for (const Point p : {Point{0, far}, Point{-0.866 * far, -0.5 * far}, Point{0.866 * far, -0.5 * far}}) {
        insert(p, least, helper);
    }
    for (const int i : hilbert_order(seeds)) insert(seeds[index(i)], weights[index(i)], i);

    PowerDiagram diagram;
    diagram.vertices.reserve(2 * seeds.size() + 2);
    for (const auto face : triangulation.finite_face_handles()) {
        face->info() = static_cast<int>(diagram.vertices.size());
        diagram.vertices.push_back(power_centre(face));
    }
    diagram.sides.reserve(3 * seeds.size());
    // `finite_edges` is not used, because its order depends on memory addresses.
    for (const auto face : triangulation.finite_face_handles()) {
        for (int i = 0; i < 3; ++i) {
            const int left = face->vertex(Regular::ccw(i))->info();
            const int right = face->vertex(Regular::cw(i))->info();
            // The face is on the left of the edge between the seeds, and the side points left of that.
            if (left != helper && left < right) diagram.sides.push_back({left, right, face->neighbor(i)->info(), face->info()});
        }
    }
    return diagram;
}

}  // namespace graincrack::mesher
