// The boundaries between the pieces of a picture as chains of sides of pixels.
#pragma once

#include <vector>

#include "mesher/import/label_pieces.hpp"
#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// The boundary between two pieces from one node to the next, or all around where it has no node.
struct BoundaryChain {
    int from = -1;  ///< node, −1 of a closed chain
    int to = -1;
    int left = -1;            ///< piece on the left, −1 outside of the picture
    int right = -1;           ///< piece on the right
    std::vector<Point> path;  ///< corners of pixels, also where a node was moved away from its corner; each once if closed
    bool on_outline() const { return left < 0 || right < 0; }
    bool closed() const { return from < 0; }
};

/// All boundaries of a picture, its outline too. Lengths are in pixels; y points up from the last row.
struct LabelBoundaries {
    std::vector<Point> nodes;  ///< where three or four boundaries meet, and the corners of the picture
    std::vector<BoundaryChain> chains;
    int opened_corners = 0;  ///< where a piece met itself in a point
};

/// Finds the boundaries. Where four pieces meet, they share one node. Where a piece meets itself across a corner of pixels, the
/// corner is opened: the two others, which are different pieces, get a short boundary with each other, and no piece meets
/// itself in a point.
LabelBoundaries label_boundaries(const LabelPieces& pieces);

/// Makes one junction in the middle of two between which the boundary has at most `most_sides` sides of pixels (up to 2: with
/// more, other boundaries can be in the way). Only where three pieces meet at both ends, where no end is on the outline of the
/// picture, and where no piece would touch itself in a point. \return how many boundaries are gone
int join_near_junctions(LabelBoundaries& boundaries, int most_sides);

}  // namespace graincrack::mesher
