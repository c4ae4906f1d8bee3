// Junctions of boundaries that lie closer together than a picture tells them apart.
#pragma once

#include "mesher/import/label_boundaries.hpp"

namespace graincrack::mesher {

/// Makes one junction in the middle of two between which the boundary has at most `most_sides` sides of pixels (up to 2: with
/// more, other boundaries can be in the way). Only where three pieces meet at both ends, where no end is on the outline of the
/// picture, and where no piece would touch itself in a point. \return how many boundaries are gone
int join_near_junctions(LabelBoundaries& boundaries, int most_sides);

}  // namespace graincrack::mesher
