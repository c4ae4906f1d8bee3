// Triangles of bounded size and angle in regions that share their borders.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

/// A segment between two points that is a border of regions; a region is a number from 0, −1 is outside.
struct RegionEdge {
    int from = 0, to = 0, left = -1, right = -1;
};

/// Triangles in the area of a square of their side, measured.
inline constexpr double triangles_of_square = 2.3;

/// Side of three triangles across a circle of an area: of elements where nothing else is asked for.
double side_for_area(double mean_area);

/// What is asked of triangles.
struct Refinement {
    double side = 0;  ///< about the mean of the sides, m
    /// Triangles with an angle below it are divided, degrees, where the borders do not force one; up to 20.7 it always ends.
    double smallest_angle = 20;
    std::size_t most_points = 10'000'000;
};

/// Triangles, counter-clockwise, each of one region. The first points are those that were given.
struct RefinedMesh {
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    std::vector<int> region_of_triangle;
};

/// Delaunay refinement of the regions within borders that do not cross. Points that it adds on borders belong to both sides.
/// \throws UsageError if borders cross or touch, or if more than `most_points` are needed
RefinedMesh refined_triangles(std::span<const Point> points, std::span<const RegionEdge> borders, const Refinement& refinement);

}  // namespace graincrack::mesher
