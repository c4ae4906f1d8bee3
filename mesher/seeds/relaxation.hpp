// Relaxes the inner points of a mesh to near-equal edges without a preferred direction.
#pragma once

#include <functional>
#include <vector>

#include "mesher/region/depth_grid.hpp"
#include "mesher/seeds/seeds.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Requested properties of the mesh.
struct RelaxationGoal {
    double edge = 0;          ///< edge of relative size 1, m; must fit the number of points
    double spread = 0.1;      ///< coefficient of variation of the edges over their graded size
    std::size_t n_inner = 0;  ///< number of inner points, met exactly
};

/// Largest spread that springs with a force-free range leave, to 0.02; scattered sizes make larger ones. Found by trial.
inline constexpr double widest_spring_spread = 0.16;
/// Spread that springs leave between grains of scattered sizes. Chosen by trial.
inline constexpr double tight_spread = 0.1;

/// Called with the completed fraction of the work, 0 to 1; may throw to stop.
using ProgressCallback = std::function<void(double)>;

/// Moves, splits and merges the inner points until edges are near the requested length; fixed seeds stay in place. Triangles are
/// Delaunay, or constrained to loops and prescribed edges if the loop is not convex.
///
/// A round consists of a Delaunay triangulation (O(n log n)), sweeps of springs along edges, and equally many merges of far too
/// short and splits of far too long edges. Springs alone would make patches of a regular lattice, whose directions guide cracks.
/// Two measures prevent this: (1) springs exert no force within a range about the requested length, which is adapted to reach the
/// requested spread, as is the scatter of sizes if they scatter; (2) edges around a point that share a six-fold direction are
/// rotated away from it. \throws NumericalError if the number of points cannot be met (a shape only a few edges wide);
/// Interrupted on a signal \param depth of the region, with a reach of at least 0.3 edges
Seeds relax_points(const DepthGrid& depth, Seeds fixed, const std::vector<Point>& inner, const RelaxationGoal& goal,
                   const SizeField& size = {}, const ProgressCallback& progress = {});

}  // namespace graincrack::mesher
