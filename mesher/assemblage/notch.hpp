// A notch: grain boundaries that are broken from the start.
#pragma once

#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Breaks the grain boundaries along a horizontal notch through the centre (kind `pre_existing_crack`): those between a grain
/// whose centroid lies above y = 0 and one whose centroid lies below, with their middle within half the length of x = 0. Such
/// boundaries make one zigzag line, as a notch between whole grains must be.
/// \param length requested, m; the notch ends at ends of boundaries, so that its length differs by an edge at most
void cut_notch(Specimen& specimen, double length);

}  // namespace graincrack::mesher
