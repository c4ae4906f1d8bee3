#include "mesher/elements/polygons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "mesher/cells/convex_outline.hpp"
#include "mesher/cells/cut_cells.hpp"
#include "mesher/cells/graded_areas.hpp"
#include "mesher/cells/laguerre.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/cells/relaxed_corners.hpp"
#include "mesher/cells/restored_areas.hpp"
#include "mesher/cells/short_edges.hpp"
#include "mesher/elements/divided_cells.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr int most_rounds = 2;  ///< of removing short edges and restoring areas, which can make further ones

constexpr std::size_t last_areas = 8;  ///< of each zone: they fill what the others leave

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
    ConvexOutline outline = convex_outline(region, equilateral_edge(region, static_cast<double>(request.n)), request.size);
    for (Point& p : outline.corners) p = Stretch(request.elongation).equiaxed(p);
    RandomNumbers random(request.seed);
    const GradedAreas wanted(wanted_areas(request.n, moments(outline.corners).area, request.spread, request.distribution, random),
                             request.size);
    LaguerreCells made = laguerre_cells(outline, wanted, random, progress);
    return {std::move(made.cells), outline.size(), std::move(made.wanted), made.largest_error, outline.loading_arc};
}

/// Shares areas between the zones inside, so that each has large and small ones by its room; the last, smallest ones are for the
/// zone that has the most left. None is left without.
/// \param room of the zones (`Zones::graded_area`), whose sum inside is that of the areas
std::vector<std::size_t> zones_for(std::vector<double>& areas, const Zones& zones, const std::vector<double>& room) {
    std::vector<double> left;
    std::vector<std::size_t> inside;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        if (!zones.is_inside(zone)) continue;
        inside.push_back(zone);
        left.push_back(room[zone]);
    }
    if (inside.size() > 1) std::sort(areas.begin(), areas.end(), std::greater<>());
    std::vector<std::size_t> zone_of;
    std::vector<int> count(inside.size(), 0);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const auto n_without = static_cast<std::size_t>(std::count(count.begin(), count.end(), 0));
        const bool is_last = i + last_areas * inside.size() >= areas.size();
        const auto need = [&](std::size_t k) { return is_last ? left[k] : (left[k] - areas[i] / 2) / room[inside[k]]; };
        std::size_t chosen = 0;
        for (std::size_t k = 1; k < inside.size(); ++k) {
            const bool is_better = areas.size() - i <= n_without ? count[k] < count[chosen] : need(k) > need(chosen);
            if (is_better) chosen = k;
        }
        left[chosen] -= areas[i];
        ++count[chosen];
        zone_of.push_back(inside[chosen]);
    }
    return zone_of;
}

/// Adds cells that fill the zones outside, and scales all to the zones they are in.
void fill_zones(std::vector<double>& areas, std::vector<std::size_t>& zone_of, const Zones& zones,
                const std::vector<double>& room) {
    const double mean = std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size());
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        if (zones.is_inside(zone)) continue;
        const auto n = static_cast<std::size_t>(std::lround(room[zone] / mean));
        for (std::size_t i = 0; i < n; ++i) {
            areas.push_back(zones.area(zone) / static_cast<double>(n));
            zone_of.push_back(zone);
        }
    }
    std::vector<double> sum(zones.size(), 0);
    for (std::size_t i = 0; i < areas.size(); ++i) sum[zone_of[i]] += areas[i];
    for (std::size_t i = 0; i < areas.size(); ++i) areas[i] *= zones.area(zone_of[i]) / sum[zone_of[i]];
}

/// Refuses crystals that have no room, at a place if that is known: by the names of the flaws there.
[[noreturn]] void refuse_without_room(const Region& region, double edge, const std::optional<Point>& place) {
    std::vector<std::pair<double, std::string>> near;
    for (const PrescribedEdge& e : region.edges) {
        const double distance = place ? curves_of({region.name, {}, {e}}).front().distance(*place) : edge;
        const bool is_new = std::none_of(near.begin(), near.end(), [&](const auto& other) { return other.second == e.name; });
        if (distance < edge && !e.name.empty() && is_new) near.emplace_back(distance, e.name);
    }
    std::sort(near.begin(), near.end());
    if (near.empty()) throw UsageError("--grains: holes and flaws leave no room for polygons of this size; give smaller ones");
    throw UsageError(fmt::format("{}: leaves no room for polygons with an edge of {}{}; move it, or give smaller polygons",
                                 near.front().second, format_length(edge), near.size() > 1 ? " beside " + near[1].second : ""));
}

Crystals crystals_between_walls(const Region& region, const PolygonRequest& request,
                                const std::function<void(double)>& progress) {
    const Walls walls =
        walls_of(region, equilateral_edge(region, static_cast<double>(request.n)), Stretch(request.elongation), request.size);
    const Zones zones(walls);
    double inside = 0;
    double whole = moments(walls.hull.corners).area;
    std::vector<double> room;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        room.push_back(zones.graded_area(zone, request.size));
        inside += zones.is_inside(zone) ? room.back() : 0;
    }
    Crystals best;
    best.largest_error = std::numeric_limits<double>::infinity();
    std::optional<Point> no_room;
    for (int attempt = 0; attempt < most_attempts && best.largest_error > enough; ++attempt) {
        RandomNumbers random(request.seed, static_cast<std::uint64_t>(attempt));
        std::vector<double> wanted = wanted_areas(request.n, inside, request.spread, request.distribution, random);
        std::vector<std::size_t> zone_of = zones_for(wanted, zones, room);
        fill_zones(wanted, zone_of, zones, room);
        // Zones outside that are smaller than a cell have none.
        const double scale = whole / std::accumulate(wanted.begin(), wanted.end(), 0.0);
        std::vector<double> scaled = wanted;
        for (double& area : scaled) area *= scale;
        const GradedAreas graded(std::move(scaled), request.size, zone_of);
        LaguerreCells made = laguerre_cells_in_zones(walls, zones, zone_of, graded, random, progress);
        if (graded.are_graded()) wanted = made.wanted;

        if (!(made.largest_error < 1)) continue;
        std::size_t n_removed = remove_short_edges(made.cells, walls.hull.size(), very_short_edge).n_removed;
        std::optional<CutCells> cut = cut_cells(made.cells, wanted, walls, zones, zone_of, request.size, no_room.emplace());

        if (!cut || cut->cells.size() != request.n) continue;
        n_removed += remove_short_edges(cut->cells, cut->n_fixed, very_short_edge).n_removed;
        const double error = restore_areas(cut->cells, cut->n_fixed, cut->areas);

        bool is_whole = true;
        for (std::size_t cell = 0; cell < request.n && is_whole; ++cell) {
            is_whole = is_sound(corners_of(cut->cells, cell));
            no_room = moments(corners_of(cut->cells, cell)).centroid;
        }

        if (is_whole && error < best.largest_error) {
            best = {std::move(cut->cells), cut->n_fixed, std::move(cut->areas), error, walls.loading_arc, n_removed};
        }
    }
    if (best.cells.size() == request.n) return best;
    if (no_room) no_room = Stretch(request.elongation).elongated(*no_room);
    refuse_without_room(region, equilateral_edge(region, static_cast<double>(request.n)), no_room);
}

/// Diameters of crystals, and how they follow the grading.
/// \param cells in the plane in which they are equiaxed
void measure_sizes(const Region& region, const PolygonRequest& request, const PlaneCells& cells, PolygonStatistics& statistics) {
    const std::vector<double> areas = areas_of(cells);
    statistics.n_crystals = areas.size();
    const auto diameter_of = [](double area) { return std::sqrt(4 * area / std::numbers::pi); };
    for (const double area : areas) statistics.mean_diameter += diameter_of(area);
    statistics.mean_diameter /= static_cast<double>(areas.size());
    std::vector<double> relative = areas;
    std::optional<GradedSize> graded;
    if (request.grading) graded.emplace(*request.grading, region);
    std::array<double, 2> n{};
    const double mean_area = std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size());
    const double equal_diameter = diameter_of(mean_area / (1 + request.spread * request.spread));
    for (std::size_t cell = 0; graded && cell < areas.size(); ++cell) {
        const Point place = moments(corners_of(cells, cell)).centroid;
        const double size = request.size.graded(place);
        relative[cell] /= size * size;
        const std::optional<std::size_t> end = graded->end_at(Stretch(request.elongation).elongated(place));
        if (!end) continue;
        n[*end] += 1;
        statistics.graded_diameter[*end] += diameter_of(areas[cell]);
        statistics.wanted_diameter[*end] += equal_diameter * size;
    }
    statistics.diameter_variation = diameter_variation(relative);
    for (const std::size_t end : {0U, 1U}) {
        if (n[end] == 0) continue;
        statistics.graded_diameter[end] /= n[end];
        statistics.wanted_diameter[end] /= n[end];
    }
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
    measure_sizes(region, request, made.cells, statistics);
    if (request.elongation.ratio > 1) {
        for (Point& p : made.cells.points) p = Stretch(request.elongation).elongated(p);
        statistics.elongation = elongation_of(made.cells);
    }
    std::function<double(Point)> relative_size;
    if (request.grading && request.are_elements_graded) {
        relative_size = [&](Point p) { return request.size.graded(Stretch(request.elongation).equiaxed(p)); };
    }
    return {divided_cells(made.cells, request.bodies, request.element_size, relative_size), made.loading_arc, statistics};
}

}  // namespace graincrack::mesher
