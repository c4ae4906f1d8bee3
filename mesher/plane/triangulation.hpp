// Delaunay triangulations of points in the plane, and related exact tests.
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
/// Decisions are exact (CGAL's exact predicates), so that points on a common circle or line are handled correctly. The cost is
/// O(n log n); it is lowest for points in Hilbert order.
class DelaunayMesh {
public:
    DelaunayMesh();
    ~DelaunayMesh();
    DelaunayMesh(const DelaunayMesh&) = delete;
    DelaunayMesh& operator=(const DelaunayMesh&) = delete;

    /// Triangulates other points.
    void build(std::span<const Point> points);
    /// Moves the points; points on the hull must not move. For small moves it is about four times faster than `build`.
    void move(std::span<const Point> points);
    /// The triangles; their order depends on the calls so far only.
    [[nodiscard]] std::vector<Triangle> triangles() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The undirected edges of triangles, ascending, each once.
std::vector<Edge> edges_of(std::span<const Triangle> triangles, std::size_t n_points);

/// Splits the single triangle that cuts off a corner of the outline (an "ear" with two boundary edges and an overlong third one).
/// It exchanges the diagonal with the neighbouring triangle, so that the corner belongs to two triangles.
/// \param corner index of the corner point; `before`, `after` indices of its neighbours on the outline, counter-clockwise
/// \return true if there was an ear and it could be split (the far point does not lie on one line with a side)
bool split_corner_ear(std::span<const Point> points, std::vector<Triangle>& triangles, int corner, int before, int after);

/// Order of points along a Hilbert curve over their bounding box.
std::vector<int> hilbert_order(std::span<const Point> points);

/// Name and version of the library, as in "CGAL 5.5.1".
std::string triangulation_library();

/// Delaunay triangles of points within loops, with given edges (constrained Delaunay triangulation).
/// \param loops sides of closed loops that do not cross; triangles inside an odd number of loops are kept
/// \param inner further edges that must be sides of triangles
/// \throws UsageError if two edges cross
std::vector<Triangle> constrained_triangles(std::span<const Point> points, std::span<const Edge> loops,
                                            std::span<const Edge> inner = {});

/// True if a closed loop nowhere turns right, by exact arithmetic.
bool is_convex(std::span<const Point> loop);
/// True if the sides of a closed loop meet at its corners only.
bool is_simple(std::span<const Point> loop);

}  // namespace graincrack::mesher
