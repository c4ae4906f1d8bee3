#include "mesher/plane/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/version_macros.h>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
/// State of a face of a constrained triangulation: visited or not, inside or outside.
enum class Place { unvisited, beyond, within };
using Face = CGAL::Triangulation_face_base_with_info_2<Place, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;

/// Marks the faces by a flood fill from outside that changes sides at each loop.
void mark_places(Constrained& triangulation, std::span<const Edge> loops) {
    std::vector<Edge> borders;
    for (const Edge& e : loops) borders.push_back(edge_between(e[0], e[1]));
    std::sort(borders.begin(), borders.end());
    for (const auto face : triangulation.all_face_handles()) face->info() = Place::unvisited;
    std::vector<Constrained::Face_handle> reached{triangulation.infinite_face()};
    reached.front()->info() = Place::beyond;
    while (!reached.empty()) {
        const auto face = reached.back();
        reached.pop_back();
        for (int i = 0; i < 3; ++i) {
            const auto next = face->neighbor(i);
            if (next->info() != Place::unvisited) continue;
            const bool crosses =
                face->is_constrained(i) && std::binary_search(borders.begin(), borders.end(),
                                                              edge_between(face->vertex(Constrained::cw(i))->info(),
                                                                           face->vertex(Constrained::ccw(i))->info()));
            next->info() = crosses == (face->info() == Place::beyond) ? Place::within : Place::beyond;
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
    constexpr const char* crossing_edges =
        "edges of the region cross or touch each other; move holes and flaws apart, or give smaller grains";
    try {
        for (const auto& edges : {loops, inner}) {
            for (const Edge& e : edges) {
                const auto from = vertices[index(e[0])];
                const auto to = vertices[index(e[1])];
                if (from == to) throw UsageError(crossing_edges);  // two points at one place
                triangulation.insert_constraint(from, to);
            }
        }
    } catch (const Constrained::Intersection_of_constraints_exception&) {
        throw UsageError(crossing_edges);
    }
    mark_places(triangulation, loops);
    std::vector<Triangle> triangles;
    for (const auto face : triangulation.finite_face_handles()) {
        if (face->info() != Place::within) continue;
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

bool is_simple(std::span<const Point> loop) {
    std::vector<Kernel::Point_2> corners;
    for (const Point p : loop) corners.emplace_back(p.x, p.y);
    return CGAL::is_simple_2(corners.begin(), corners.end());
}

namespace {

using Structure = CGAL::Triangulation_data_structure_2<Vertex>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Structure>;

/// Position of a cell of a 2^24 × 2^24 grid along the Hilbert curve.
std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y) {
    constexpr std::uint32_t levels = 24;
    std::uint64_t key = 0;
    for (std::uint32_t s = 1U << (levels - 1); s > 0; s >>= 1U) {
        const std::uint32_t right = (x & s) != 0 ? 1 : 0;
        const std::uint32_t upper = (y & s) != 0 ? 1 : 0;
        key = 4 * key + ((3 * right) ^ upper);
        if (upper == 0) {  // the curve is mirrored in the two lower quadrants
            if (right == 1) {
                x = ~x;
                y = ~y;
            }
            std::swap(x, y);
        }
    }
    return key;
}

}  // namespace

struct DelaunayMesh::State {
    Delaunay delaunay;
    std::vector<Delaunay::Vertex_handle> vertices;  ///< [points] vertex

    [[nodiscard]] bool is_turned_over(const Delaunay::Face_handle& f) const {
        return CGAL::orientation(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()) != CGAL::LEFT_TURN;
    }
    /// True if the point beyond side i of a triangle lies strictly inside its circumcircle.
    [[nodiscard]] bool must_flip(const Delaunay::Face_handle& f, int i) const {
        const auto beyond = f->neighbor(i);
        if (delaunay.is_infinite(beyond) || delaunay.is_infinite(f)) return false;
        const auto& p = delaunay.tds().mirror_vertex(f, i)->point();
        return CGAL::side_of_oriented_circle(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(), p) ==
               CGAL::ON_POSITIVE_SIDE;
    }
    /// Applies Lawson's flips until every pair of triangles is Delaunay; all triangles must be counter-clockwise.
    void restore() {
        std::vector<std::pair<Delaunay::Face_handle, int>> sides;
        const auto check_later = [&](const Delaunay::Face_handle& f) {
            for (int i = 0; i < 3; ++i) sides.emplace_back(f, i);
        };
        for (const auto face : delaunay.finite_face_handles()) {
            check_later(face);
            while (!sides.empty()) {
                const auto [f, i] = sides.back();
                sides.pop_back();
                if (!must_flip(f, i)) continue;
                const auto beyond = f->neighbor(i);
                delaunay.tds().flip(f, i);
                check_later(f);
                check_later(beyond);
            }
        }
    }
};

DelaunayMesh::DelaunayMesh() : state_(std::make_unique<State>()) {}
DelaunayMesh::~DelaunayMesh() = default;

void DelaunayMesh::build(std::span<const Point> points) {
    Delaunay& delaunay = state_->delaunay;
    delaunay.clear();
    state_->vertices.resize(points.size());
    Delaunay::Face_handle hint;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto vertex = delaunay.insert({points[i].x, points[i].y}, hint);
        vertex->info() = static_cast<int>(i);
        state_->vertices[i] = vertex;
        hint = vertex->face();
    }
}

void DelaunayMesh::move(std::span<const Point> points) {
    for (std::size_t i = 0; i < points.size(); ++i) state_->vertices[i]->set_point({points[i].x, points[i].y});
    const auto faces = state_->delaunay.finite_face_handles();
    if (std::any_of(faces.begin(), faces.end(), [&](const auto& f) { return state_->is_turned_over(f); })) {
        build(points);
    } else {
        state_->restore();
    }
}

std::vector<Triangle> DelaunayMesh::triangles() const {
    std::vector<Triangle> triangles;
    triangles.reserve(state_->delaunay.number_of_faces());
    for (const auto face : state_->delaunay.finite_face_handles()) {
        triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    return triangles;
}

std::vector<Edge> edges_of(std::span<const Triangle> triangles, std::size_t n_points) {
    // This is a counting sort by the smaller point; the few edges of a point are then sorted and made unique.
    std::vector<int> start(n_points + 1, 0);
    const auto for_each_side = [&](const auto& visit) {
        for (const Triangle& t : triangles) {
            for (std::size_t k = 0; k < 3; ++k) visit(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]));
        }
    };
    for_each_side([&](int low, int) { ++start[index(low) + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> ends(3 * triangles.size());
    std::vector<int> fill(start.begin(), start.end() - 1);
    for_each_side([&](int low, int high) { ends[static_cast<std::size_t>(fill[index(low)]++)] = high; });

    std::vector<Edge> edges;
    edges.reserve(2 * triangles.size());
    for (std::size_t p = 0; p < n_points; ++p) {
        const auto first = ends.begin() + start[p];
        const auto last = ends.begin() + start[p + 1];
        std::sort(first, last);
        for (auto it = first; it != last; ++it) {
            if (it == first || *it != *(it - 1)) edges.push_back({static_cast<int>(p), *it});
        }
    }
    return edges;
}

bool split_corner_ear(std::span<const Point> points, std::vector<Triangle>& triangles, int corner, int before, int after) {
    const auto has = [](const Triangle& t, int p) { return t[0] == p || t[1] == p || t[2] == p; };
    const auto ear = std::find_if(triangles.begin(), triangles.end(),
                                  [&](const Triangle& t) { return has(t, corner) && has(t, before) && has(t, after); });
    if (ear == triangles.end()) return false;
    const auto beyond = std::find_if(triangles.begin(), triangles.end(),
                                     [&](const Triangle& t) { return !has(t, corner) && has(t, before) && has(t, after); });
    if (beyond == triangles.end()) return false;
    const int apex = (*beyond)[0] + (*beyond)[1] + (*beyond)[2] - before - after;
    const Triangle first{corner, after, apex};
    const Triangle second{corner, apex, before};
    const auto area = [&](const Triangle& t) {
        return signed_area(points[index(t[0])], points[index(t[1])], points[index(t[2])]);
    };
    if (std::min(area(first), area(second)) < 0.25 * area(*ear)) return false;
    *ear = first;
    *beyond = second;
    return true;
}

std::vector<int> hilbert_order(std::span<const Point> points) {
    std::vector<int> order(points.size());
    const Box box = box_of(points);
    const double extent = std::max(box.width(), box.height());
    const double scale = extent > 0 ? 16777215.0 / extent : 0;  // one point has no extent
    std::vector<std::pair<std::uint64_t, int>> keyed(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto x = static_cast<std::uint32_t>((points[i].x - box.low.x) * scale);
        const auto y = static_cast<std::uint32_t>((points[i].y - box.low.y) * scale);
        keyed[i] = {hilbert_key(x, y), static_cast<int>(i)};
    }
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = keyed[i].second;
    return order;
}

std::string triangulation_library() { return "CGAL " CGAL_VERSION_STR; }

}  // namespace graincrack::mesher
