// Prescribed edges made to fit the grains: clipped to the region, moved where an end almost meets something, else refused.
#pragma once

#include <string>
#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// The pieces of a region's prescribed edges that a mesh of mean edge `edge` can follow.
///
/// Pieces lie inside; an end nearer than `closest_ends` edges to the boundary or to another piece is moved along its own line to
/// meet it, of what is needed by no more than that. What then lies upon, or runs beside another or the boundary nearer than that,
/// meets it under an angle below `sharpest_meeting`, or is shorter than half an edge, is left out if it is not needed, else
/// refused. \param moves gets a sentence for each end of needed edges that moved by more than `told_move` edges
/// \throws UsageError naming the edges at fault
std::vector<PrescribedEdge> fitted_edges(const Region& region, double edge, std::vector<std::string>* moves = nullptr);

inline constexpr double closest_ends = 0.35;      ///< over the mean edge
inline constexpr double told_move = 0.1;          ///< likewise
inline constexpr double sharpest_meeting = 0.26;  ///< rad, 15°

}  // namespace graincrack::mesher
