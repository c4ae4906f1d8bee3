// Finds the lines along which polygonal cells are cut: their own edges and walls, divided where they meet.
#pragma once

#include <map>
#include <vector>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/walls.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Lines that divide the hull of walls and meet in points only.
struct CellLines {
    static constexpr int no_wall = -1;
    static constexpr int extension = -2;  ///< extension of a wall to the side of the cell in which it ends

    std::vector<Point> points;
    std::vector<char> is_fixed;     ///< [points] true for corners of the hull, and corners, ends and meetings of walls
    std::vector<Side> sides;        ///< of the walls, then of the hull
    std::vector<Edge> hull;         ///< pieces of the sides of the hull
    std::map<Edge, int> side_of;    ///< number of the side on which each line lies, `extension` or `no_wall`
    std::map<Edge, int> cell_left;  ///< cell on the left of each directed piece of the cells' edges
};

/// Moves points of cells near walls onto them, and divides edges of cells and walls where they meet. Walls that end inside a cell
/// are extended to its side. Each wall is compared with each edge of the cells. \param cells cells of the hull of the walls
/// \param mean_size root of the mean area of cells, m \param size graded size, over it
CellLines cell_lines(const PlaneCells& cells, const Walls& walls, double mean_size, const SizeField& size);

}  // namespace graincrack::mesher
