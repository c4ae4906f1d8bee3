// Polygonal cells cut along walls, and pieces joined until there are as many cells as before.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/walls.hpp"

namespace graincrack::mesher {

struct CutCells {
    PlaneCells cells;           ///< within the loops of the walls, whose sides follow them; fixed points first
    std::size_t n_fixed = 0;    ///< corners of loops, ends and meetings of prescribed edges
    std::vector<double> areas;  ///< wanted, m²: of each cell one that was asked for, scaled to fill what walls close off
};

/// Cuts cells along walls. Points of cells that lie near a wall are moved onto it first. A crystal in which a wall ends is cut
/// through along its line, unless a point of it is near enough to be moved to the end. Of the pieces those that are the smallest
/// shares of their cells join the neighbour with the longest common side, until there are as many as seeds.
/// \param cells of the hull of the walls \param seeds of the cells \param areas wanted of the cells, m²
/// \param size graded, by which areas are wanted at other places
/// \param no_room set to a place where cells have no room between walls, unless null
/// \return nothing if there is one
std::optional<CutCells> cut_cells(const PlaneCells& cells, std::span<const Point> seeds, const std::vector<double>& areas,
                                  const Walls& walls, const SizeField& size = {}, Point* no_room = nullptr);

}  // namespace graincrack::mesher
