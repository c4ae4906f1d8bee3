// Makes triangles of bounded size and angle in regions that share borders.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

/// A segment on the border of regions, which are numbered from 0; −1 is outside.
struct RegionEdge {
    int from = 0, to = 0, left = -1, right = -1;
};

/// Mean number of triangles in the square of their side. Measured; no record kept.
inline constexpr double triangles_of_square = 2.3;

/// Default side of elements: three triangles lie across a circle of the mean area (m²).
double side_for_area(double mean_area);

/// Requirements of triangles.
struct Refinement {
    double side = 0;  ///< approximate mean of the sides, m
    /// Angle (degrees) below which triangles are divided unless borders force one; refinement always ends up to 20.7.
    double smallest_angle = 20;
    std::size_t most_points = 10'000'000;
};

/// Triangles, counter-clockwise, each in one region. The given points come first.
struct RefinedMesh {
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    std::vector<int> region_of_triangle;
};

/// Refines regions within borders that do not cross (Delaunay refinement). Points added on borders belong to both sides.
/// \throws UsageError if borders cross or meet between their ends, or if more than `most_points` are needed
RefinedMesh refined_triangles(std::span<const Point> points, std::span<const RegionEdge> borders, const Refinement& refinement);

}  // namespace graincrack::mesher
