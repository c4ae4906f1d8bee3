// Fits prescribed edges to the grains: clips them to the region, and moves ends that almost meet something or refuses the edge.
#pragma once

#include <string>
#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// Returns the pieces of the region's prescribed edges that a mesh of mean edge `edge` (m) can follow.
///
/// All pieces lie inside the region. An end nearer than `closest_ends` edges to the boundary or to another piece moves along its
/// own line until it meets it; an end of a needed edge moves by no more than that. A piece does not fit if it then lies upon
/// another piece, runs nearer than that beside another or the boundary, meets one under less than `sharpest_meeting`, or is
/// shorter than half an edge. Such a piece is left out, or refused if it is needed. The cost grows with the square of the number
/// of pieces n, up to its cube if all pieces meet. \param moves gets a sentence for each end of a needed edge that moved by more
/// than `told_move` edges \throws UsageError naming the edges that do not fit
std::vector<PrescribedEdge> fitted_edges(const Region& region, double edge, std::vector<std::string>* moves = nullptr);

// Chosen by trial; not varied since.
inline constexpr double closest_ends = 0.35;      ///< smallest distance of pieces, over the mean edge
inline constexpr double told_move = 0.1;          ///< largest move without a sentence, over the mean edge
inline constexpr double sharpest_meeting = 0.26;  ///< smallest angle between pieces, rad (15°)

}  // namespace graincrack::mesher
