#include "mesher/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "mesher/assemblage/separate_bodies.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/cells/statistics.hpp"
#include "mesher/elements/divided_cells.hpp"

namespace graincrack::mesher {

namespace {

constexpr double element_count_tolerance = 0.02;  ///< of a requested number of elements per crystal
constexpr double least_angle = 0.2;               ///< smallest angle of elements on round holes, rad
constexpr int max_element_trials = 8;
constexpr std::int64_t crystals_of_trial = 500;

PlaneMesh divided_crystals(const Request& request, const TessellatedRegion& made, double element_size) {
    const Fabric& fabric = request.fabric;
    std::function<double(Point)> relative_size;
    if (made.plan.size.varies() && !fabric.element_size) {
        relative_size = [&](Point p) { return made.plan.size.graded(Stretch(fabric.elongation).equiaxed(p)); };
    }
    const Bodies bodies = fabric.tessellation == Tessellation::trigon ? Bodies::triangles : Bodies::cells;
    return divided_cells(made.cells, bodies, element_size, relative_size);
}

/// Element size that gives crystals the requested number of elements, by trial on these crystals or, if they are many, on fewer
/// with the same sizes. Corners require additional elements, so that the number does not follow from the size alone.
double element_size_for(const Request& request, const TessellatedRegion& made) {
    double size = made.plan.element_size;
    if (!request.fabric.elements_per_crystal) return size;
    Request trial = request;
    std::optional<TessellatedRegion> fewer;
    if (made.plan.n_grains > crystals_of_trial) {
        const double side = std::sqrt(area(made.plan.region) * crystals_of_trial / static_cast<double>(made.plan.n_grains));
        trial.region = rectangle(side, side);
        centre_region(trial.region);
        trial.fabric.grading.reset();  // crystals have equal numbers of elements everywhere
        MeshPlan plan;
        plan.region = trial.region;
        plan.n_grains = crystals_of_trial;
        plan.edge = equilateral_edge(plan.region, crystals_of_trial);
        fewer = tessellate(trial, std::move(plan));
    }
    const TessellatedRegion& tried = fewer ? *fewer : made;
    for (int i = 0; i < max_element_trials; ++i) {
        const auto n_elements = static_cast<double>(divided_crystals(trial, tried, size).triangles.size());
        const double ratio = n_elements / (*request.fabric.elements_per_crystal * static_cast<double>(tried.plan.n_grains));
        if (std::abs(ratio - 1) < element_count_tolerance) break;
        size *= std::sqrt(ratio);
    }
    return size;
}

/// True if a flaw or a joint ends on a hole, which then keeps the shape of its cells.
bool meets_flaw(const PlaneMesh& mesh, int part) {
    std::set<int> on_hole;
    for (const Side& side : mesh.sides) {
        if (side.part == part) on_hole.insert({side.from, side.to});
    }
    return std::any_of(mesh.sides.begin(), mesh.sides.end(), [&](const Side& side) {
        return side.part < 0 && (on_hole.contains(side.from) || on_hole.contains(side.to));
    });
}

/// The smallest angle of the triangles that have points on a part of the boundary, rad.
double smallest_angle_at(const PlaneMesh& mesh, int part) {
    std::vector<bool> is_on_part(mesh.points.size(), false);
    for (const Side& side : mesh.sides) {
        if (side.part == part) is_on_part[index(side.from)] = true;
    }
    double smallest = std::numbers::pi;
    for (const Triangle& t : mesh.triangles) {
        if (std::none_of(t.begin(), t.end(), [&](int p) { return is_on_part[index(p)]; })) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point at = mesh.points[index(t[k])];
            const Point u = mesh.points[index(t[(k + 1) % 3])] - at;
            const Point v = mesh.points[index(t[(k + 2) % 3])] - at;
            smallest = std::min(smallest, std::atan2(cross(u, v), dot(u, v)));
        }
    }
    return smallest;
}

/// Moves the points on round holes, where cells have few points, to circles of the radius at which their polygons have the areas
/// of the holes, unless elements would become bad.
void round_holes(const Region& region, PlaneMesh& mesh) {
    bool has_moved = false;
    for (const Loop& loop : region.loops) {
        const int part = loop.parts.front();
        if (!loop.circle || &loop == &region.loops.front() || meets_flaw(mesh, part)) continue;
        const Point centre = loop.circle->centre;
        const auto from_centre = [&](int p) { return unit(mesh.points[index(p)] - centre); };
        double doubled_area = 0;  // of the polygon of radius 1
        for (const Side& side : mesh.sides) {
            if (side.part == part) doubled_area += std::abs(cross(from_centre(side.from), from_centre(side.to)));
        }
        const double angle_before = smallest_angle_at(mesh, part);
        const std::vector<Point> before = mesh.points;
        const double corners = loop.circle->radius * std::sqrt(2 * std::numbers::pi / doubled_area);
        for (const Side& side : mesh.sides) {
            if (side.part == part) mesh.points[index(side.from)] = centre + corners * from_centre(side.from);
        }
        has_moved = true;
        if (smallest_angle_at(mesh, part) < std::min(angle_before, least_angle)) mesh.points = before;
    }
    if (has_moved) mesh.complete_bodies();
}

/// Makes the elements of the cells, rotated so that the loaded diameter lies along y, and measures the elongation.
PlaneMesh elements_of(const Request& request, TessellatedRegion& made) {
    const Fabric& fabric = request.fabric;
    PlaneMesh elements;
    if (fabric.has_crystals()) {
        elements = divided_crystals(request, made, element_size_for(request, made));
        round_holes(request.region, elements);
        turn_to_load(request.region, elements.points);
    }
    turn_to_load(request.region, made.cells.points);
    if (fabric.elongation.ratio > 1) {
        const Elongation measured = elongation_of(made.cells);
        made.statistics.elongation = measured.ratio;
        made.statistics.elongation_angle = measured.angle;
    }
    return fabric.has_crystals() ? elements : lattice_mesh(std::move(made.cells), fabric.elements_per_edge);
}

/// Statistics of crystals: those of their specimen, with the elongation of their cells.
MeshStatistics statistics_of_crystals(const Specimen& specimen, const Region& region, const MeshStatistics& of_cells) {
    MeshStatistics statistics = statistics_of(specimen);
    const double total = std::accumulate(specimen.grain_area.begin(), specimen.grain_area.end(), 0.0);
    statistics.area_error = total / area(region) - 1;
    statistics.elongation = of_cells.elongation;
    statistics.elongation_angle = of_cells.elongation_angle;
    return statistics;
}

/// [g] a number with the sign of the y of the grain's centroid.
std::vector<double> grain_heights(const Specimen& s) {
    std::vector<double> height(s.n_grains(), 0.0);
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        // Elements of a grain have equal size, so the mean of their nodes is the grain's centroid.
        for (const std::int32_t node : s.element_nodes[e]) height[index(s.element_grain[e])] += s.node_position[index(node)][1];
    }
    return height;
}

/// Breaks the grain boundaries along a horizontal notch through the centre: those between grains with centroids above and below y
/// = 0, with their middle within half the length (m) of x = 0. They form one zigzag line, as a notch between whole grains must,
/// whose length differs from the requested one by at most an edge.
void cut_notch(Specimen& specimen, double length) {
    const std::vector<double> height = grain_heights(specimen);
    const std::vector<std::int32_t> grain = grain_of_nodes(specimen);
    const auto above = [&](std::int32_t node) { return height[index(grain[index(node)])] > 0; };
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const auto& [a1, a2, b1, b2] = specimen.contact_nodes[c];
        const double middle = 0.5 * (specimen.node_position[index(a1)][0] + specimen.node_position[index(a2)][0]);
        if (above(a1) != above(b1) && std::abs(middle) <= 0.5 * length) {
            specimen.contact_kind[c] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
        }
    }
}

}  // namespace

Specimen mesh(const Request& request, const ProgressCallback& progress, MeshReport* report) {
    const Fabric& fabric = request.fabric;
    TessellatedRegion made = tessellate(request, plan_mesh(request), progress);
    const PlaneMesh elements = elements_of(request, made);
    std::vector<int> crystal_of_grain;
    Specimen specimen = separate_bodies(elements, &crystal_of_grain);
    constexpr const char* names[] = {"delaunay", "voronoi", "trigon"};
    specimen.tessellation = names[static_cast<int>(fabric.tessellation)];
    specimen.elements_per_edge = fabric.elements_per_edge;
    specimen.loading_arc = made.loading_arc;
    specimen.shape = request.region.name;
    specimen.width = bounds(request.region).width();
    specimen.height = bounds(request.region).height();
    specimen.part_names = request.region.part_names;
    if (request.notch && !fabric.has_crystals()) cut_notch(specimen, *request.notch);
    specimen.statistics =
        fabric.has_crystals() ? statistics_of_crystals(specimen, request.region, made.statistics) : made.statistics;
    const bool can_break = fabric.tessellation == Tessellation::trigon;
    give_fabric(specimen, crystal_of_grain, fabric, request.seed, turn_to_load(request.region), can_break);
    if (report != nullptr) *report = made.report;
    return specimen;
}

}  // namespace graincrack::mesher
