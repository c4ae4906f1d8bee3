// Corners of cells moved onto walls that pass near them.
#pragma once

#include <utility>
#include <vector>

#include "mesher/cells/cell_pieces.hpp"

namespace graincrack::mesher {

/// Points of pieces on a chain of walls, in its order, each with its place: the number of the chain's side and the share of it.
using ChainNodes = std::vector<std::pair<double, int>>;

/// Moves points that lie near a chain onto it, those nearest to its corners and ends first, and adds points where the chain
/// crosses edges. An open chain is extended to the side of the cell in which it ends, unless a point can be moved to its end.
ChainNodes snapped_corners(CellPieces& pieces, WallChain& chain);

}  // namespace graincrack::mesher
