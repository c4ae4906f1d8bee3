#include "mesher/cells/crystals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "mesher/cells/cell_areas.hpp"
#include "mesher/cells/cut_cells.hpp"
#include "mesher/cells/laguerre.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/cells/relaxed_corners.hpp"
#include "mesher/cells/short_edges.hpp"
#include "mesher/cells/statistics.hpp"
#include "mesher/plane/refined_triangulation.hpp"
#include "mesher/region/shapes.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr int most_rounds = 2;  ///< rounds of removing short edges and restoring areas, which can create further ones

constexpr std::size_t last_areas = 8;  ///< last areas of each zone, which fill the room left by others

constexpr std::int64_t max_crystals = 1'000'000;
constexpr double max_elements = 15e6;
/// Default side of elements over the edge of crystals. Chosen by trial (after 0.5, 0.38): about seven elements a crystal, eight
/// at spread 0.6.
constexpr double element_over_edge = 0.36;

constexpr int most_attempts = 12;  ///< attempts at cells between walls
constexpr double enough = 1e-6;    ///< area error at which no further attempt is made

/// Cells with their requested areas, and the number of fixed points.
struct CrystalsInPlane {
    PlaneCells cells;
    std::size_t n_fixed = 0;
    std::vector<double> areas;
    double largest_error = 0, loading_arc = 0;
    std::size_t n_short_edges = 0;  ///< number of removed short edges
};

std::vector<double> drawn_areas(const Fabric& fabric, const MeshPlan& plan, double total, RandomNumbers& random) {
    return requested_areas(static_cast<std::size_t>(plan.n_grains), total, fabric.spread,
                           fabric.size_distribution.value_or(SizeDistribution::normal), random);
}

CrystalsInPlane plain_crystals(const Request& request, const MeshPlan& plan, const Walls& walls,
                               const ProgressCallback& progress) {
    RandomNumbers random(request.seed);
    const GradedAreas requested(drawn_areas(request.fabric, plan, moments(walls.hull.corners).area, random), plan.size);
    LaguerreCells made = laguerre_cells(walls.hull, requested, random, progress);
    return {std::move(made.cells), walls.hull.size(), std::move(made.requested), made.largest_error, walls.loading_arc};
}

/// Distributes areas to the inner zones by their room, so that each has large and small ones. The last and smallest areas go to
/// the zone with most room left. No zone is left empty.
/// \param room room of the zones (`Zones::graded_area`), whose sum inside is that of the areas
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

/// Adds cells that fill the outer zones, and scales all areas to their zones.
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

/// Refuses crystals without room, naming the flaws at a position if it is known.
[[noreturn]] void refuse_without_room(const Region& region, double edge, const std::optional<Point>& position) {
    std::vector<std::pair<double, std::string>> near;
    for (const PrescribedEdge& e : region.edges) {
        const double distance = position ? curves_of({region.name, {}, {e}}).front().distance(*position) : edge;
        const bool is_new = std::none_of(near.begin(), near.end(), [&](const auto& other) { return other.second == e.name; });
        if (distance < edge && !e.name.empty() && is_new) near.emplace_back(distance, e.name);
    }
    std::sort(near.begin(), near.end());
    if (near.empty()) throw UsageError("--grains: holes and flaws leave no room for crystals of this size; give smaller ones");
    throw UsageError(fmt::format("{}: leaves no room for crystals with an edge of {}{}; move it, or give smaller crystals",
                                 near.front().second, format_length(edge), near.size() > 1 ? " beside " + near[1].second : ""));
}

CrystalsInPlane crystals_between_walls(const Request& request, const MeshPlan& plan, const Walls& walls,
                                       const ProgressCallback& progress) {
    const Zones zones(walls);
    const auto n = static_cast<std::size_t>(plan.n_grains);
    double inside = 0;
    const double whole = moments(walls.hull.corners).area;
    std::vector<double> room;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        room.push_back(zones.graded_area(zone, plan.size));
        inside += zones.is_inside(zone) ? room.back() : 0;
    }
    CrystalsInPlane best;
    best.largest_error = std::numeric_limits<double>::infinity();
    std::optional<Point> no_room;
    for (int attempt = 0; attempt < most_attempts && best.largest_error > enough; ++attempt) {
        RandomNumbers random(request.seed, static_cast<std::uint64_t>(attempt));
        std::vector<double> requested = drawn_areas(request.fabric, plan, inside, random);
        std::vector<std::size_t> zone_of = zones_for(requested, zones, room);
        fill_zones(requested, zone_of, zones, room);
        // Outer zones smaller than a cell have no cells.
        const double scale = whole / std::accumulate(requested.begin(), requested.end(), 0.0);
        std::vector<double> scaled = requested;
        for (double& area : scaled) area *= scale;
        const GradedAreas graded(std::move(scaled), plan.size, zone_of);
        LaguerreCells made = laguerre_cells_in_zones(walls, zones, zone_of, graded, random, progress);
        if (graded.are_graded()) requested = made.requested;

        if (!(made.largest_error < 1)) continue;
        std::size_t n_removed = remove_short_edges(made.cells, walls.hull.size(), very_short_edge).n_removed;
        std::optional<CutCells> cut = cut_cells(made.cells, requested, walls, zones, zone_of, plan.size, no_room.emplace());
        if (!cut || cut->cells.size() != n) continue;
        n_removed += remove_short_edges(cut->cells, cut->n_fixed, very_short_edge).n_removed;
        const double error = restore_areas(cut->cells, cut->n_fixed, cut->areas);
        bool is_whole = true;
        for (std::size_t cell = 0; cell < n && is_whole; ++cell) {
            is_whole = is_sound(corners_of(cut->cells, cell));
            no_room = moments(corners_of(cut->cells, cell)).centroid;
        }
        if (!is_whole || error >= best.largest_error) continue;
        best = {std::move(cut->cells), cut->n_fixed, std::move(cut->areas), error, walls.loading_arc, n_removed};
    }
    if (best.cells.size() == n) return best;
    if (no_room) no_room = Stretch(request.fabric.elongation).elongated(*no_room);
    refuse_without_room(plan.region, plan.edge, no_room);
}

/// Removes short edges and restores areas. If this is impossible, fewer edges count as short; the very short ones are always
/// removed.
void merge_short_edges(CrystalsInPlane& made, MeshReport& report) {
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
        report.largest_area_error = error;
        report.n_short_edges += n_removed;
        report.n_edges_left = edges.n_left;
        return;
    }
}

}  // namespace

MeshPlan plan_crystals(const Request& request) {
    const Fabric& fabric = request.fabric;
    MeshPlan plan;
    plan.region = request.region;
    const double whole = area(plan.region);
    plan.n_grains =
        fabric.grains
            ? *fabric.grains
            : static_cast<std::int64_t>(std::min(std::round(4 * whole / (std::sqrt(3.0) * *fabric.edge * *fabric.edge)), 1e18));
    const std::string option = fabric.grains ? "--grains: " : "--edge: ";
    if (plan.n_grains < 2) {
        throw UsageError(option + "crystals are at least two; give " + (fabric.grains ? "2" : "a smaller edge"));
    }
    if (plan.n_grains > max_crystals) {
        throw UsageError(fmt::format("{}{} crystals are too many; at most {} are made", option, plan.n_grains, max_crystals));
    }
    plan.edge = plan.equal_edge = equilateral_edge(plan.region, static_cast<double>(plan.n_grains));
    plan.element_size = fabric.element_size.value_or(element_over_edge * plan.edge);
    if (fabric.elements_per_crystal) {
        const double n_elements = *fabric.elements_per_crystal * static_cast<double>(plan.n_grains);
        plan.element_size = std::sqrt(triangles_of_square * whole / n_elements);
    }
    if (!(triangles_of_square * whole / (plan.element_size * plan.element_size) <= max_elements)) {
        throw UsageError(fmt::format("--element-size: {} would make more than {:.0f} elements; at least {} is needed",
                                     format_length(plan.element_size), max_elements,
                                     format_length(std::sqrt(triangles_of_square * whole / max_elements))));
    }
    if (request.notch) plan.region.edges.push_back(central_slit(plan.region, *request.notch, 0, "--slit"));
    add_edges(request, plan);
    if (fabric.grading) plan.size = SizeField(plan.region, plan.edge, fabric.grading, Stretch(fabric.elongation), 0);
    if (!is_plain(plan.region)) check_walls(request, plan);
    return plan;
}

TessellatedRegion crystals(const Request& request, MeshPlan plan, const ProgressCallback& progress) {
    const Walls walls = walls_of(plan.region, plan.edge, Stretch(request.fabric.elongation), plan.size);
    CrystalsInPlane made =
        walls.divide() ? crystals_between_walls(request, plan, walls, progress) : plain_crystals(request, plan, walls, progress);
    TessellatedRegion result;
    result.report.n_short_edges = made.n_short_edges;
    merge_short_edges(made, result.report);
    result.report.largest_area_error = relax_corners(made.cells, made.n_fixed, made.areas);
    measure_diameters(plan, made.cells, result.report);
    if (request.fabric.elongation.ratio > 1) {
        for (Point& p : made.cells.points) p = Stretch(request.fabric.elongation).elongated(p);
    }
    result.plan = std::move(plan);
    result.cells = std::move(made.cells);
    result.loading_arc = made.loading_arc;
    return result;
}

}  // namespace graincrack::mesher
