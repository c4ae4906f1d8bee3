// Measures of polygons given by their corners, counter-clockwise, and of cells.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/plane/stretch.hpp"

namespace graincrack::mesher {

/// Area of a polygon, m², and its centroid.
struct PolygonMoments {
    double area = 0;
    Point centroid;
};
PolygonMoments moments(const std::vector<Point>& corners);

/// True if all sides are clearly visible from the centroid, so that the polygon has an area and does not cross itself.
bool is_sound(std::span<const Point> loop);

std::vector<Point> corners_of(const PlaneCells& cells, std::size_t cell);

/// Areas of cells, m².
std::vector<double> areas_of(const PlaneCells& cells);

/// [points] direction of the side on which a point lies and may move; 0 inside.
std::vector<Point> tangents_of(const PlaneCells& cells);

/// Elongation of cells: the square root of the ratio of the principal values of Σ e⊗e over their edges e, and the direction of
/// the larger, −90° to 90°. It recovers an affine map of cells without a preferred direction. The squared length as weight gives
/// equal areas equal weight, whatever their grain sizes.
Elongation elongation_of(const PlaneCells& cells);

}  // namespace graincrack::mesher
