// The lines along which polygonal cells are cut: their own edges and walls, divided where they meet.
#pragma once

#include <map>
#include <vector>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/walls.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Lines that divide the hull of walls and meet in points alone.
struct CellLines {
    static constexpr int no_wall = -1;
    static constexpr int extension = -2;  ///< of a wall to the side of the cell in which it ends

    std::vector<Point> points;
    std::vector<char> is_fixed;     ///< [points] corners of the hull; corners, ends and meetings of walls
    std::vector<Side> sides;        ///< of the walls, then of the hull
    std::vector<Edge> hull;         ///< pieces of its sides
    std::map<Edge, int> side_of;    ///< of each line the number of the side on which it lies, `extension` or `no_wall`
    std::map<Edge, int> cell_left;  ///< of the pieces of cells' edges, in the direction in which they go round a cell
};

/// Moves points of cells that lie near walls onto them, and divides the edges of cells and the walls where they meet. Walls that
/// end inside of a cell are continued to its side.
/// \param cells of the hull of the walls \param mean_size root of the mean area of cells \param size graded, over it
CellLines cell_lines(const PlaneCells& cells, const Walls& walls, double mean_size, const SizeField& size);

}  // namespace graincrack::mesher
