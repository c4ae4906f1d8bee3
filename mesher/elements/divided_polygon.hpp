// Divides a polygon into triangles between its points.
#pragma once

#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

/// Places points inside a polygon one after another. Each is placed farthest from the points of the boundary and earlier points,
/// until no place is about an element's size away from all of them. Time and memory are linear in the number of elements.
/// \param boundary corners counter-clockwise, with points on the sides; not necessarily convex
/// \param size side of elements, m
/// \return the points, ordered so that neighbours are near each other
std::vector<Point> placed_points(std::span<const Point> boundary, double size);

struct DividedPolygon {
    std::vector<Point> inner;         ///< points that were added inside
    std::vector<Triangle> triangles;  ///< of the points of the boundary, then the inner ones; counter-clockwise
};

/// Divides a polygon into triangles with sides of about a size (m). No point is added on its boundary. Points inside are placed
/// (`placed_points`) and moved so that triangles allow the longest time steps.
/// \param boundary corners counter-clockwise, with points on the sides; not necessarily convex
DividedPolygon divided_polygon(std::span<const Point> boundary, double size);

}  // namespace graincrack::mesher
