#include "mesher/cells/delaunay.hpp"

#include <utility>

namespace graincrack::mesher {

PlaneCells delaunay_cells(Seeds seeds) {
    PlaneCells cells;
    cells.corners.reserve(3 * seeds.triangles.size());
    cells.start.reserve(seeds.triangles.size() + 1);
    for (const Triangle& t : seeds.triangles) {
        cells.corners.insert(cells.corners.end(), t.begin(), t.end());
        cells.start.push_back(static_cast<int>(cells.corners.size()));
    }
    cells.points = std::move(seeds.points);
    cells.edges = std::move(seeds.edges);
    cells.sides = std::move(seeds.sides);
    return cells;
}

}  // namespace graincrack::mesher
