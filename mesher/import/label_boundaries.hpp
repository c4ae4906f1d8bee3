// Finds the boundaries between the pieces of a picture as chains of pixel sides.
#pragma once

#include <vector>

#include "mesher/import/label_pieces.hpp"
#include "mesher/plane/geometry.hpp"

namespace graincrack::mesher {

/// The boundary between two pieces from one node to the next, or a closed one without nodes.
struct BoundaryChain {
    int from = -1;  ///< node; −1 for a closed chain
    int to = -1;
    int left = -1;            ///< piece on the left; −1 outside of the picture
    int right = -1;           ///< piece on the right
    std::vector<Point> path;  ///< corners of pixels, also if a node was moved off its corner; each once if closed
    bool on_outline() const { return left < 0 || right < 0; }
    bool closed() const { return from < 0; }
};

/// All boundaries of a picture and its outline. Lengths are in pixels; y points up from the last row.
struct LabelBoundaries {
    std::vector<Point> nodes;  ///< meetings of three or four boundaries, and the corners of the picture
    std::vector<BoundaryChain> chains;
    int opened_corners = 0;  ///< number of corners at which a piece met itself
};

/// Finds the boundaries. Four pieces that meet share one node. If a piece meets itself across a corner of pixels, the corner is
/// opened: the two other pieces, which differ, get a short common boundary, and no piece meets itself in a point.
LabelBoundaries label_boundaries(const LabelPieces& pieces);

/// Replaces two junctions by one in the middle if the boundary between them has at most `most_sides` pixel sides (up to 2: with
/// more, other boundaries can be in the way). This requires that three pieces meet at both ends, that no end is on the outline,
/// and that no piece would meet itself in a point. \return number of removed boundaries
int join_near_junctions(LabelBoundaries& boundaries, int most_sides);

}  // namespace graincrack::mesher
