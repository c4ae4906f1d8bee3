// Pieces of cells joined until there are as many as seeds.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesher/cells/cell_pieces.hpp"

namespace graincrack::mesher {

/// Drops pieces outside of the walls' loops. Of the others those that are the smallest shares of their cells join the neighbour
/// with the longest common side, until between walls there are as many as seeds; where there are fewer, the largest are halved.
/// \param wanted areas of the cells of the seeds, m² \param no_room set to a place where pieces have no room, if so
/// \return areas wanted of the pieces, m², or nothing if pieces have no room
std::optional<std::vector<double>> joined_pieces(CellPieces& pieces, std::span<const Point> seeds,
                                                 const std::vector<double>& wanted, Point& no_room);

}  // namespace graincrack::mesher
