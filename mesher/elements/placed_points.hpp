// Points inside a polygon at about equal distances.
#pragma once

#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// Places points inside a polygon one after another, each where it is farthest from the boundary's points and from those before,
/// until no place is left that is about an element's size away from all of them. Time and memory are in proportion to the number
/// of elements.
/// \param boundary corners counter-clockwise, with points on the sides; not necessarily convex
/// \param size side of elements, m
/// \return in an order in which neighbours are near each other
std::vector<Point> placed_points(std::span<const Point> boundary, double size);

}  // namespace graincrack::mesher
