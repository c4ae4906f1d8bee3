// Relaxation of the inner points of a mesh: near-equal edges without a preferred direction.
#pragma once

#include <functional>
#include <vector>

#include "mesher/region/depth_grid.hpp"
#include "mesher/seeds/seeds.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Requested properties of the mesh.
struct RelaxationGoal {
    double edge = 0;          ///< requested edge of relative size 1, m; must fit the number of points
    double spread = 0.1;      ///< requested coefficient of variation of the edges over their graded size
    std::size_t n_inner = 0;  ///< requested number of inner points, met exactly
};

/// Widest spread that springs leave by a range without force, to 0.02; a wider one is made by sizes that scatter.
inline constexpr double widest_spring_spread = 0.16;
/// Spread that springs leave between grains whose sizes scatter.
inline constexpr double tight_spread = 0.1;

/// Called with the share of work done, 0 to 1; may throw to stop.
using ProgressCallback = std::function<void(double)>;

/// Moves, splits and merges the inner points until the edges are near the requested length; fixed seeds stay where they are.
/// Triangles are Delaunay, within the loops and along the prescribed edges (constrained) where the loop is not convex.
///
/// A round consists of a Delaunay triangulation, sweeps of springs along the edges, and as many merges of edges that are far too
/// short as splits of edges that are far too long. Springs alone would produce patches of a regular lattice, whose directions
/// would guide cracks. Two measures prevent this: (1) springs exert no force within a range about the requested length, which is
/// adapted to reach the requested spread, as is the scatter of the sizes where they scatter; (2) where the edges around a point
/// share a six-fold direction, they are turned away from it. \throws NumericalError if the number of points cannot be met (a
/// shape only a few edges wide); Interrupted on a signal \param depth of the region, with a reach of 0.3 edges at least
Seeds relax_points(const DepthGrid& depth, Seeds fixed, const std::vector<Point>& inner, const RelaxationGoal& goal,
                   const SizeField& size = {}, const ProgressCallback& progress = {});

}  // namespace graincrack::mesher
