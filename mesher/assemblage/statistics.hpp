// Statistics of cells: sizes of edges and grains, angles, preferred direction, area.
#pragma once

#include "mesher/cells/plane_cells.hpp"
#include "mesher/region/region.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Statistics of the cells of a region, which become grains; a coefficient of variation is the standard deviation over the mean.
MeshStatistics statistics_of(const Region& region, const PlaneCells& cells);

}  // namespace graincrack::mesher
