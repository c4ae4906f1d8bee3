// Statistics of a mesh: sizes of edges and grains, angles, preferred direction, area.
#pragma once

#include "mesher/point_relaxation.hpp"
#include "mesher/shape.hpp"
#include "share/specimen.hpp"

namespace graincrack::mesher {

/// Statistics of a mesh of a shape; a coefficient of variation is the standard deviation over the mean.
MeshStatistics mesh_statistics(const Shape& shape, const PlaneMesh& mesh);

}  // namespace graincrack::mesher
