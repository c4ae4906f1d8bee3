// Cuts polygonal cells along walls, and joins the pieces until there are as many cells as before.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/walls.hpp"

namespace graincrack::mesher {

struct CutCells {
    PlaneCells cells;           ///< cells within the loops of the walls; their sides follow the walls; fixed points come first
    std::size_t n_fixed = 0;    ///< number of fixed points: corners of loops, ends and meetings of prescribed edges
    std::vector<double> areas;  ///< [cells] requested areas, m²: the given ones in another order, scaled to fill each zone
};

/// Cuts cells along walls. Points of cells near a wall are first moved onto it. If a wall ends within a cell, the cell is cut
/// through along the line of the wall, unless one of its points is near enough to be moved to the end. In each zone the pieces
/// that are the smallest fractions of their cells then join the neighbour with the longest common side, until there are as many
/// pieces as cells of the zone. Each join sorts the pieces left in the zone, so that the cost grows with the product of joins and
/// pieces. \param cells cells of the hull of the walls \param areas [cells] requested areas, m² \param zone_of_cell [cells]
/// \param size graded sizes, which scale areas that move \param no_room set to a place where cells have no room between walls
/// \return empty if there is such a place
std::optional<CutCells> cut_cells(const PlaneCells& cells, const std::vector<double>& areas, const Walls& walls,
                                  const Zones& zones, std::span<const std::size_t> zone_of_cell, const SizeField& size,
                                  Point& no_room);

}  // namespace graincrack::mesher
