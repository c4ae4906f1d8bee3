// Delaunay triangulation of points within loops, convex or not, with prescribed edges.
#pragma once

#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

/// Delaunay triangles of points within loops, with given edges (constrained Delaunay triangulation).
/// \param loops sides of closed loops that do not cross; a triangle is kept if an odd number of loops is around it
/// \param inner further edges that must be sides of triangles
/// \throws UsageError if two edges cross
std::vector<Triangle> constrained_triangles(std::span<const Point> points, std::span<const Edge> loops,
                                            std::span<const Edge> inner = {});

/// Whether a closed loop nowhere turns right, by exact arithmetic.
bool is_convex(std::span<const Point> loop);

}  // namespace graincrack::mesher
