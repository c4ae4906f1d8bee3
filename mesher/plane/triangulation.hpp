// Delaunay triangulation of points of a convex outline.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// Three points, counter-clockwise, as indices.
using Triangle = std::array<int, 3>;
/// Two points, the smaller index first unless said otherwise.
using Edge = std::array<int, 2>;
inline Edge edge_between(int p, int q) { return {std::min(p, q), std::max(p, q)}; }

/// Delaunay triangulation of distinct points that do not all lie on one line; its triangles cover their convex hull.
///
/// Decisions are exact (CGAL's exact predicates), so that points on a common circle or line are handled correctly. Points that
/// are sorted in space (Hilbert order) are triangulated fastest.
class DelaunayMesh {
public:
    DelaunayMesh();
    ~DelaunayMesh();
    DelaunayMesh(const DelaunayMesh&) = delete;
    DelaunayMesh& operator=(const DelaunayMesh&) = delete;

    /// Triangulates points anew.
    void build(std::span<const Point> points);
    /// Moves the points; those on the hull must stay. For small moves some four times faster than `build`.
    void move(std::span<const Point> points);
    /// The triangles, in an order that depends only on the calls so far.
    [[nodiscard]] std::vector<Triangle> triangles() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The undirected edges of triangles, ascending, each once.
std::vector<Edge> edges_of(std::span<const Triangle> triangles, std::size_t n_points);

/// Where a single triangle cuts off a corner of the outline (an "ear": two boundary edges and an overlong third one), exchanges
/// the diagonal with the neighbouring triangle, so that the corner belongs to two triangles.
/// \param corner index of the corner point; `before`, `after` those of its neighbours on the outline, counter-clockwise
/// \return whether there was an ear and it could be split (the far point does not lie on one line with a side)
bool split_corner_ear(std::span<const Point> points, std::vector<Triangle>& triangles, int corner, int before, int after);

/// Order of points along a Hilbert curve over their bounding box.
std::vector<int> hilbert_order(std::span<const Point> points);

/// "CGAL 5.5.1" and the like.
std::string triangulation_library();

/// Delaunay triangles of points within loops, with given edges (constrained Delaunay triangulation).
/// \param loops sides of closed loops that do not cross; a triangle is kept if an odd number of loops is around it
/// \param inner further edges that must be sides of triangles
/// \throws UsageError if two edges cross
std::vector<Triangle> constrained_triangles(std::span<const Point> points, std::span<const Edge> loops,
                                            std::span<const Edge> inner = {});

/// Whether a closed loop nowhere turns right, by exact arithmetic.
bool is_convex(std::span<const Point> loop);
/// Whether the sides of a closed loop meet at its corners alone.
bool is_simple(std::span<const Point> loop);

}  // namespace graincrack::mesher
