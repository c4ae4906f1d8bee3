// Makes polygonal cells of given areas: the Laguerre tessellation of a convex outline.
#pragma once

#include <functional>
#include <vector>

#include "mesher/cells/cell_areas.hpp"
#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/walls.hpp"
#include "mesher/plane/random_numbers.hpp"

namespace graincrack::mesher {

struct LaguerreCells {
    PlaneCells cells;               ///< convex; the corners of the outline are the first points
    std::vector<double> areas;      ///< areas of the cells, m²
    std::vector<double> requested;  ///< requested areas at the final places, m²
    double largest_error = 0;       ///< largest error of an area, over the requested one
    std::vector<Point> seeds;
};

/// Makes compact cells at random places with the requested areas, to 1e-6 of each.
///
/// The cells are those of a power diagram. The weights that give the requested areas maximise a concave function; its gradient is
/// requested minus present areas, its second derivatives are −length/(2 distance of seeds) of the sides between cells
/// (Aurenhammer, Hoffmann & Aronov 1998). Newton's method with steps that leave every cell an area converges from any seeds
/// (Kitagawa, Mérigot & Thibert 2019); a step solves a sparse linear system in the number of cells. Between its first steps seeds
/// move to the centroids of their cells (Lloyd), which makes them compact. Graded areas are those at the seeds, which are denser
/// where cells are smaller.
/// \param areas requested areas, m², whose sum is the area of the outline \param progress called with the completed fraction
/// \throws Error if the areas are not reached, which is unlikely for areas above 0; Interrupted on a signal
LaguerreCells laguerre_cells(const ConvexOutline& outline, const GradedAreas& areas, RandomNumbers& random,
                             const std::function<void(double)>& progress = {});

/// Makes cells of about the requested areas whose seeds stay in their zones, away from walls, so that few cells cross a wall.
/// \param zone_of_cell [cells] \throws Interrupted on a signal
LaguerreCells laguerre_cells_in_zones(const Walls& walls, const Zones& zones, const std::vector<std::size_t>& zone_of_cell,
                                      const GradedAreas& areas, RandomNumbers& random,
                                      const std::function<void(double)>& progress = {});

}  // namespace graincrack::mesher
