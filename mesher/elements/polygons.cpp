#include "mesher/elements/polygons.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "mesher/cells/convex_outline.hpp"
#include "mesher/cells/laguerre.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/cells/restored_areas.hpp"
#include "mesher/cells/short_edges.hpp"
#include "mesher/elements/refined.hpp"

namespace graincrack::mesher {

namespace {

constexpr int most_rounds = 2;  ///< of removing short edges and restoring areas, which can make further ones

}  // namespace

double equilateral_edge(const Region& region, double n_polygons) {
    return std::sqrt(4 * area(region) / (std::numbers::sqrt3 * n_polygons));
}

PolygonMesh polygon_mesh(const Region& region, const PolygonRequest& request, const std::function<void(double)>& progress) {
    const ConvexOutline outline = convex_outline(region, equilateral_edge(region, static_cast<double>(request.n)));
    RandomNumbers random(request.seed);
    const std::vector<double> wanted =
        wanted_areas(request.n, moments(outline.corners).area, request.spread, request.distribution, random);
    LaguerreCells made = laguerre_cells(outline, wanted, random, progress);
    PolygonStatistics statistics;
    statistics.largest_area_error = made.largest_error;
    for (int round = 0; round < most_rounds; ++round) {
        const ShortEdges edges = remove_short_edges(made.cells, outline.size());
        statistics.n_short_edges += edges.n_removed;
        statistics.n_edges_left = edges.n_left;
        if (edges.n_removed == 0) break;
        statistics.largest_area_error = restore_areas(made.cells, outline.size(), wanted);
    }
    const std::vector<double> areas = areas_of(made.cells);
    statistics.n_crystals = areas.size();
    for (const double area : areas) statistics.mean_diameter += std::sqrt(4 * area / std::numbers::pi);
    statistics.mean_diameter /= static_cast<double>(areas.size());
    statistics.diameter_variation = diameter_variation(areas);
    return {refined_mesh(made.cells, request.bodies, request.element_size), outline.loading_arc, statistics};
}

}  // namespace graincrack::mesher
