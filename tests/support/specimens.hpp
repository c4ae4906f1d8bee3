// Small specimens with known answers, built by hand so that solver tests need no mesher.
#pragma once

#include <array>
#include <vector>

#include "share/specimen.hpp"

namespace graincrack::test {

using Point = std::array<double, 2>;
using Triangle = std::array<int, 3>;

/// A specimen whose grains are the given counter-clockwise triangles; edges shared by two triangles become contacts. Boundary
/// edges on the bounding box are named bottom, right, top, left; others rim.
Specimen specimen_of_triangles(const std::vector<Point>& points, const std::vector<Triangle>& triangles);
/// The same with several triangles to a grain: `grain[i]` is the grain of triangle i, ascending from 0.
Specimen specimen_of_grains(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                            const std::vector<int>& grain);

/// Rectangle about the origin in nx × ny cells of two triangles with the diagonals all one way.
Specimen one_diagonal_grid(int nx, int ny, double width, double height);
/// The same with the diagonals alternating (union jack).
Specimen union_jack_grid(int nx, int ny, double width, double height);
/// Rectangle with inner points moved by up to `jitter` of a cell, in a fixed pattern without direction.
Specimen jittered_grid(int nx, int ny, double width, double height, double jitter);
/// The same specimen turned by `angle` (rad) about the origin.
Specimen rotated(Specimen specimen, double angle);

}  // namespace graincrack::test
