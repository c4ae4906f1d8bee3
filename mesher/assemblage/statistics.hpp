// Statistics of cells: sizes of edges and grains, angles, preferred direction, area.
#pragma once

#include "mesher/cells/plane_cells.hpp"
#include "mesher/region/region.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Statistics of the cells of a region, which become grains; a coefficient of variation is the standard deviation over the mean.
MeshStatistics statistics_of(const Region& region, const PlaneCells& cells);

/// Statistics of an assemblage that was not made of cells. Of grains that are single triangles edges are theirs; of others an
/// edge stands for a grain: that of the equilateral triangle of its area. The error of the area is 0: the boundary is the shape.
MeshStatistics statistics_of(const Specimen& specimen);

}  // namespace graincrack::mesher
