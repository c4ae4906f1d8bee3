#include "mesher/elements/polygons.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "mesher/cells/convex_outline.hpp"
#include "mesher/cells/laguerre.hpp"
#include "mesher/cells/short_edges.hpp"
#include "mesher/elements/refined.hpp"

namespace graincrack::mesher {

double equilateral_edge(const Region& region, double n_polygons) {
    return std::sqrt(4 * area(region) / (std::numbers::sqrt3 * n_polygons));
}

PolygonMesh polygon_mesh(const Region& region, const PolygonRequest& request, const std::function<void(double)>& progress) {
    const ConvexOutline outline = convex_outline(region, equilateral_edge(region, static_cast<double>(request.n)));
    RandomNumbers random(request.seed);
    const std::vector<double> wanted =
        wanted_areas(request.n, moments(outline.corners).area, request.spread, request.distribution, random);
    LaguerreCells made = laguerre_cells(outline, wanted, random, progress);
    const ShortEdges edges = remove_short_edges(made.cells, outline.size());

    PolygonMesh result;
    result.loading_arc = outline.loading_arc;
    PolygonStatistics& statistics = result.statistics;
    const std::vector<double> areas = areas_of(made.cells);
    statistics.n_crystals = areas.size();
    for (const double area : areas) statistics.mean_diameter += std::sqrt(4 * area / std::numbers::pi);
    statistics.mean_diameter /= static_cast<double>(areas.size());
    statistics.diameter_variation = diameter_variation(areas);
    statistics.largest_area_error = made.largest_error;
    statistics.n_short_edges = edges.n_removed;
    statistics.n_edges_left = edges.n_left;
    result.mesh = refined_mesh(made.cells, request.bodies, request.element_size);
    return result;
}

}  // namespace graincrack::mesher
