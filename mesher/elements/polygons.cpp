#include "mesher/elements/polygons.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "mesher/cells/convex_outline.hpp"
#include "mesher/cells/cut_cells.hpp"
#include "mesher/cells/laguerre.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/cells/relaxed_corners.hpp"
#include "mesher/cells/restored_areas.hpp"
#include "mesher/cells/short_edges.hpp"
#include "mesher/elements/divided_cells.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

constexpr int most_rounds = 2;  ///< of removing short edges and restoring areas, which can make further ones

constexpr int most_attempts = 12;  ///< at cells between walls
constexpr double enough = 1e-6;    ///< error of areas that needs no further attempt

/// Cells with the areas they are to have, and how many points are fixed.
struct Crystals {
    PlaneCells cells;
    std::size_t n_fixed = 0;
    std::vector<double> areas;
    double largest_error = 0;
    double loading_arc = 0;
    std::size_t n_short_edges = 0;  ///< that were removed
};

Crystals plain_crystals(const Region& region, const PolygonRequest& request, const std::function<void(double)>& progress) {
    ConvexOutline outline = convex_outline(region, equilateral_edge(region, static_cast<double>(request.n)));
    for (Point& p : outline.corners) p = Stretch(request.elongation).equiaxed(p);
    RandomNumbers random(request.seed);
    std::vector<double> wanted =
        wanted_areas(request.n, moments(outline.corners).area, request.spread, request.distribution, random);
    LaguerreCells made = laguerre_cells(outline, wanted, random, progress);
    return {std::move(made.cells), outline.size(), std::move(wanted), made.largest_error, outline.loading_arc};
}

/// Shares areas, each for the zone that has the most left, between the zones inside; none is left without.
std::vector<std::size_t> zones_for(std::vector<double>& areas, const Zones& zones) {
    std::vector<double> left;
    std::vector<std::size_t> inside;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        if (!zones.is_inside(zone)) continue;
        inside.push_back(zone);
        left.push_back(zones.area(zone));
    }
    if (inside.size() > 1) std::sort(areas.begin(), areas.end(), std::greater<>());
    std::vector<std::size_t> zone_of;
    std::vector<int> count(inside.size(), 0);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const auto n_without = static_cast<std::size_t>(std::count(count.begin(), count.end(), 0));
        std::size_t chosen = 0;
        for (std::size_t k = 1; k < inside.size(); ++k) {
            const bool is_better = areas.size() - i <= n_without ? count[k] < count[chosen] : left[k] > left[chosen];
            if (is_better) chosen = k;
        }
        left[chosen] -= areas[i];
        ++count[chosen];
        zone_of.push_back(inside[chosen]);
    }
    return zone_of;
}

/// Adds cells that fill the zones outside, and scales all to the zones they are in.
void fill_zones(std::vector<double>& areas, std::vector<std::size_t>& zone_of, const Zones& zones) {
    const double mean = std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size());
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        if (zones.is_inside(zone)) continue;
        const auto n = static_cast<std::size_t>(std::lround(zones.area(zone) / mean));
        for (std::size_t i = 0; i < n; ++i) {
            areas.push_back(zones.area(zone) / static_cast<double>(n));
            zone_of.push_back(zone);
        }
    }
    std::vector<double> sum(zones.size(), 0);
    for (std::size_t i = 0; i < areas.size(); ++i) sum[zone_of[i]] += areas[i];
    for (std::size_t i = 0; i < areas.size(); ++i) areas[i] *= zones.area(zone_of[i]) / sum[zone_of[i]];
}

Crystals crystals_between_walls(const Region& region, const PolygonRequest& request,
                                const std::function<void(double)>& progress) {
    const Walls walls = walls_of(region, equilateral_edge(region, static_cast<double>(request.n)), Stretch(request.elongation));
    const Zones zones(walls);
    double inside = 0;
    double whole = moments(walls.hull.corners).area;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) inside += zones.is_inside(zone) ? zones.area(zone) : 0;
    Crystals best;
    best.largest_error = std::numeric_limits<double>::infinity();
    for (int attempt = 0; attempt < most_attempts && best.largest_error > enough; ++attempt) {
        RandomNumbers random(request.seed, static_cast<std::uint64_t>(attempt));
        std::vector<double> wanted = wanted_areas(request.n, inside, request.spread, request.distribution, random);
        std::vector<std::size_t> zone_of = zones_for(wanted, zones);
        fill_zones(wanted, zone_of, zones);
        // Zones outside that are smaller than a cell have none.
        const double scale = whole / std::accumulate(wanted.begin(), wanted.end(), 0.0);
        std::vector<double> scaled = wanted;
        for (double& area : scaled) area *= scale;
        LaguerreCells made = laguerre_cells_in_zones(walls, zones, zone_of, scaled, random, progress);

        if (!(made.largest_error < 1)) continue;
        std::size_t n_removed = remove_short_edges(made.cells, walls.hull.size(), very_short_edge).n_removed;
        std::optional<CutCells> cut = cut_cells(made.cells, made.seeds, wanted, walls);

        if (!cut || cut->cells.size() != request.n) continue;
        n_removed += remove_short_edges(cut->cells, cut->n_fixed, very_short_edge).n_removed;
        const double error = restore_areas_in_steps(cut->cells, cut->n_fixed, cut->areas);

        bool is_whole = true;
        for (std::size_t cell = 0; cell < request.n; ++cell) is_whole = is_whole && is_sound(corners_of(cut->cells, cell));

        if (is_whole && error < best.largest_error) {
            best = {std::move(cut->cells), cut->n_fixed, std::move(cut->areas), error, walls.loading_arc, n_removed};
        }
    }
    if (best.cells.size() == request.n) return best;
    throw UsageError("--grains: holes and flaws leave no room for polygons of this size; give smaller ones");
}

/// Removes short edges and restores areas. Where that cannot be done, fewer edges count as short; the very short ones are always
/// removed.
void merge_short_edges(Crystals& made, PolygonStatistics& statistics) {
    for (const double short_below : {short_edge, 0.5 * (short_edge + very_short_edge), very_short_edge}) {
        PlaneCells cells = made.cells;
        double error = made.largest_error;
        std::size_t n_removed = 0;
        ShortEdges edges;
        for (int round = 0; round < most_rounds; ++round) {
            edges = remove_short_edges(cells, made.n_fixed, short_below);
            n_removed += edges.n_removed;
            if (edges.n_removed == 0) break;
            error = restore_areas(cells, made.n_fixed, made.areas);
        }
        if (error > std::max(enough, made.largest_error) && short_below > very_short_edge) continue;
        made.cells = std::move(cells);
        statistics.largest_area_error = error;
        statistics.n_short_edges += n_removed;
        statistics.n_edges_left = edges.n_left;
        return;
    }
}

}  // namespace

double equilateral_edge(const Region& region, double n_polygons) {
    return std::sqrt(4 * area(region) / (std::numbers::sqrt3 * n_polygons));
}

PolygonMesh polygon_mesh(const Region& region, const PolygonRequest& request, const std::function<void(double)>& progress) {
    Crystals made =
        is_plain(region) ? plain_crystals(region, request, progress) : crystals_between_walls(region, request, progress);
    PolygonStatistics statistics;
    statistics.largest_area_error = made.largest_error;
    statistics.n_short_edges = made.n_short_edges;
    merge_short_edges(made, statistics);
    statistics.largest_area_error = relax_corners(made.cells, made.n_fixed, made.areas);
    const std::vector<double> areas = areas_of(made.cells);
    statistics.n_crystals = areas.size();
    for (const double area : areas) statistics.mean_diameter += std::sqrt(4 * area / std::numbers::pi);
    statistics.mean_diameter /= static_cast<double>(areas.size());
    statistics.diameter_variation = diameter_variation(areas);
    if (request.elongation.ratio > 1) {
        for (Point& p : made.cells.points) p = Stretch(request.elongation).elongated(p);
        statistics.elongation = elongation_of(made.cells);
    }
    return {divided_cells(made.cells, request.bodies, request.element_size), made.loading_arc, statistics};
}

}  // namespace graincrack::mesher
