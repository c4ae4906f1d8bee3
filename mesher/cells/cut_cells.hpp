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
    std::vector<double> areas;  ///< requested, m²: of each cell one of the given ones, scaled to fill its zone
};

/// Cuts cells along walls. Points of cells that lie near a wall are moved onto it first. A cell in which a wall ends is cut
/// through along the line of that wall, unless a point of it is near enough to be moved to the end. In each zone the pieces that
/// are the smallest fractions of their cells join the neighbour with the longest common side, until there are as many as cells of
/// the zone. \param cells of the hull of the walls \param areas requested of the cells, m² \param zone_of_cell [cells] \param
/// size graded, by which areas are requested at other places \param no_room set to a place where cells have no room between walls
/// \return nothing if there is one
std::optional<CutCells> cut_cells(const PlaneCells& cells, const std::vector<double>& areas, const Walls& walls,
                                  const Zones& zones, std::span<const std::size_t> zone_of_cell, const SizeField& size,
                                  Point& no_room);

}  // namespace graincrack::mesher
