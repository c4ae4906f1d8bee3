// Reduces the points of lines without making lines cross.
#pragma once

#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// A line between two points, or a closed line, whose last point is its first.
struct DenseLine {
    std::vector<Point> points;
    double spacing = 0;       ///< requested distance between points
    double tolerance = 0;     ///< largest distance of removed points from the resulting line
    double doubled_area = 0;  ///< requested, twice the area between the line and its chord, counter-clockwise, or inside
    bool is_closed = false;   ///< true if its first point may also move
};

/// Clearance of the segments of lines where points are removed.
struct Clearance {
    double distance = 0;  ///< distance from points of other lines
    double angle = 0;     ///< angle between segments that meet, rad, below π/2
};

/// Removes points of lines that meet at their ends only, if segments stay about as long as the spacing, and moves the other
/// points except ends along the normals, so that lines have the requested areas. No line crosses or meets another. Source: C.
/// Dyken, M. Dæhlen, T. Sevaldrud, Simultaneous curve simplification, J. Geogr. Syst. 11 (2009) 273–289, in CGAL. \return the
/// remaining points of each line \throws UsageError if lines cross
std::vector<std::vector<Point>> simplified_lines(std::span<const DenseLine> lines, const Clearance& clearance);

}  // namespace graincrack::mesher
