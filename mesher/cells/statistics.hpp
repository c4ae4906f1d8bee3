// Statistics of cells: sizes of edges and grains, angles, preferred direction, area.
#pragma once

#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/tessellation.hpp"
#include "mesher/region/region.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Statistics of the cells of a region, which become grains; a coefficient of variation is the standard deviation over the mean.
MeshStatistics statistics_of(const Region& region, const PlaneCells& cells);

/// Statistics of an assemblage that was not made of cells. Of grains that are single triangles edges are theirs; of others an
/// edge stands for a grain: that of the equilateral triangle of its area. The error of the area is 0: the boundary is the shape.
MeshStatistics statistics_of(const Specimen& specimen);

/// Measures the spread of edges and, where that is not the same everywhere, the smallest angle.
/// \param cells in the plane where grains are equiaxed \param report whose values are set
void measure_edges(const Region& region, const PlaneCells& cells, const SizeField& size, MeshReport& report);

/// Measures the diameters of crystals and their variation over the graded size.
/// \param cells in the plane where crystals are equiaxed \param report whose values are set
void measure_diameters(const MeshPlan& plan, const PlaneCells& cells, MeshReport& report);

}  // namespace graincrack::mesher
