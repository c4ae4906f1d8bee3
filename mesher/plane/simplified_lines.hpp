// Lines of many points with fewer, which still do not cross.
#pragma once

#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// A line between two points, or a closed one, whose last point is its first.
struct DenseLine {
    std::vector<Point> points;
    double spacing = 0;       ///< requested between points
    double tolerance = 0;     ///< largest distance of points that are left out from the line without them
    double doubled_area = 0;  ///< requested, twice that between the line and its chord, counter-clockwise, or inside
    bool is_closed = false;   ///< whether its first point may move too
};

/// What the segments of lines need of each other where points are left out.
struct Clearance {
    double distance = 0;  ///< of the points of others
    double angle = 0;     ///< where segments meet, rad, below π/2
};

/// Leaves points out of lines that meet in their ends only, where segments stay about as long as the spacing, and moves the
/// others but the ends along the normals, so that lines have the areas that are requested; both only so far as no line crosses or
/// meets another. Source: C. Dyken, M. Dæhlen, T. Sevaldrud, Simultaneous curve simplification, J. Geogr. Syst. 11 (2009)
/// 273–289, in CGAL. \return the points left of each line \throws UsageError if lines cross
std::vector<std::vector<Point>> simplified_lines(std::span<const DenseLine> lines, const Clearance& clearance);

}  // namespace graincrack::mesher
