// Computes statistics of cells: sizes of edges and grains, angles, preferred direction, area.
#pragma once

#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/tessellation.hpp"
#include "mesher/region/region.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Statistics of the cells of a region, which become grains. Coefficients of variation are standard deviations over means.
MeshStatistics statistics_of(const Region& region, const PlaneCells& cells);

/// Statistics of an assemblage that was not made of cells. Grains that are single triangles have their edges; other grains have
/// the edge of the equilateral triangle of their area. The error of the area is 0 because the boundary is the shape.
MeshStatistics statistics_of(const Specimen& specimen);

/// Measures the spread of edges and, if it varies over the region, the smallest angle.
/// \param cells in the plane where grains are equiaxed \param report receives the values
void measure_edges(const Region& region, const PlaneCells& cells, const SizeField& size, MeshReport& report);

/// Measures the diameters of crystals and their variation over the graded size.
/// \param cells in the plane where crystals are equiaxed \param report receives the values
void measure_diameters(const MeshPlan& plan, const PlaneCells& cells, MeshReport& report);

}  // namespace graincrack::mesher
