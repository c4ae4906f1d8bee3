// Polygonal cells of given areas: the Laguerre tessellation of a convex outline.
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
    std::vector<double> areas;      ///< of the cells, m²
    std::vector<double> requested;  ///< of the cells where they came to lie, m²
    double largest_error = 0;       ///< of an area, over the requested one
    std::vector<Point> seeds;
};

/// Cells at random places with the requested areas, to 1e-6 of each, and compact shapes.
///
/// The cells are those of a power diagram. Its weights solve for the areas: they are the maximum of a concave function whose
/// gradient is requested less present areas and whose second derivatives are −length/(2 distance of seeds) of the sides between
/// cells (Aurenhammer, Hoffmann & Aronov 1998); Newton's method with steps that leave every cell an area converges from any seeds
/// (Kitagawa, Mérigot & Thibert 2019). Between first steps of it seeds move to the centroids of their cells (Lloyd), which makes
/// cells compact. Graded areas are those at the seeds, which lie the denser the smaller the cells are.
/// \param areas requested, m², whose sum is the area of the outline \param progress called with the share that is done
/// \throws Error if the areas are not reached, which no areas above 0 make likely; Interrupted on a signal
LaguerreCells laguerre_cells(const ConvexOutline& outline, const GradedAreas& areas, RandomNumbers& random,
                             const std::function<void(double)>& progress = {});

/// Cells of about the requested areas whose seeds stay in their zones, away from walls: few cells lie across one.
/// \param zone_of_cell [cells] \throws Interrupted on a signal
LaguerreCells laguerre_cells_in_zones(const Walls& walls, const Zones& zones, const std::vector<std::size_t>& zone_of_cell,
                                      const GradedAreas& areas, RandomNumbers& random,
                                      const std::function<void(double)>& progress = {});

}  // namespace graincrack::mesher
