#include "mesher/elements/polygons.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "mesher/cells/convex_outline.hpp"
#include "mesher/cells/laguerre.hpp"
#include "mesher/cells/short_edges.hpp"
#include "mesher/elements/refined.hpp"

namespace graincrack::mesher {

namespace {

constexpr int most_corrections = 2;
constexpr double spread_tolerance = 0.004;  ///< of the coefficient of variation, over the wanted one

struct Crystals {
    PlaneCells cells;
    PolygonStatistics statistics;
};

Crystals make_crystals(const ConvexOutline& outline, const PolygonRequest& request, double spread,
                       const std::function<void(double)>& progress) {
    RandomNumbers random(request.seed);
    const std::vector<double> wanted =
        wanted_areas(request.n, moments(outline.corners).area, spread, request.distribution, random);
    LaguerreCells made = laguerre_cells(outline, wanted, random, progress);
    const ShortEdges edges = remove_short_edges(made.cells, outline.size());
    const std::vector<double> areas = areas_of(made.cells);
    Crystals crystals;
    PolygonStatistics& statistics = crystals.statistics;
    statistics.n_crystals = areas.size();
    for (const double area : areas) statistics.mean_diameter += std::sqrt(4 * area / std::numbers::pi);
    statistics.mean_diameter /= static_cast<double>(areas.size());
    statistics.diameter_variation = diameter_variation(areas);
    statistics.largest_area_error = made.largest_error;
    statistics.n_short_edges = edges.n_removed;
    statistics.n_edges_left = edges.n_left;
    crystals.cells = std::move(made.cells);
    return crystals;
}

}  // namespace

double equilateral_edge(const Region& region, double n_polygons) {
    return std::sqrt(4 * area(region) / (std::numbers::sqrt3 * n_polygons));
}

PolygonMesh polygon_mesh(const Region& region, const PolygonRequest& request, const std::function<void(double)>& progress) {
    const ConvexOutline outline = convex_outline(region, equilateral_edge(region, static_cast<double>(request.n)));
    double spread = request.spread;
    Crystals crystals = make_crystals(outline, request, spread, progress);
    // Short edges change areas, and of few crystals also their variation.
    for (int i = 0; i < most_corrections && request.spread > 0; ++i) {
        const double ratio = crystals.statistics.diameter_variation / request.spread;
        if (std::abs(ratio - 1) < spread_tolerance) break;
        spread /= ratio;
        Crystals next = make_crystals(outline, request, spread, progress);
        if (std::abs(next.statistics.diameter_variation / request.spread - 1) >= std::abs(ratio - 1)) break;
        crystals = std::move(next);
    }
    return {refined_mesh(crystals.cells, request.bodies, request.element_size), outline.loading_arc, crystals.statistics};
}

}  // namespace graincrack::mesher
