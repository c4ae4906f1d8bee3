#include "mesher/cells/tessellation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mesher/cells/crystals.hpp"
#include "mesher/cells/triangles.hpp"
#include "mesher/region/fit_edges.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::size_t max_edges = 3000;  ///< prescribed edges; each is compared with each
constexpr double smallest_radius = 0.9;  ///< radius of a round boundary over the edge: a polygon of about five edges
constexpr double thinnest_wall = 0.5;    ///< width between round holes and the boundary, over the edge

/// An option of triangles or crystals only.
struct OptionOfKind {
    const char* message;
    bool of_crystals;
    bool (*is_given)(const Fabric&);
};
constexpr OptionOfKind options_of_kind[] = {
    {"--elements-per-crystal: is for crystals; give --elements-per-edge, or --tessellation voronoi", true,
     [](const Fabric& fabric) { return fabric.elements_per_crystal.has_value(); }},
    {"--element-size: is for crystals; give --elements-per-edge, or --tessellation voronoi", true,
     [](const Fabric& fabric) { return fabric.element_size.has_value(); }},
    {"--size-distribution: is for crystals; give --tessellation voronoi or trigon", true,
     [](const Fabric& fabric) { return fabric.size_distribution.has_value(); }},
    {"--elements-per-edge: crystals have elements of --element-size; leave it out, or give --tessellation delaunay", false,
     [](const Fabric& fabric) { return fabric.elements_per_edge != 1; }},
};

void check(const Fabric& fabric) {
    if (fabric.edge.has_value() == fabric.grains.has_value()) {
        throw UsageError(
            "give exactly one of --edge (mean edge), --grains (number of grains) and --grain-size, or a --material whose "
            "[fabric] has a grain_size");
    }
    if (!(fabric.spread >= 0 && fabric.spread <= fabric.widest_spread())) {
        throw UsageError("--spread: " + format_number(fabric.spread) + " is out of range; give 0 to " +
                         format_number(fabric.widest_spread()));
    }
    for (const OptionOfKind& option : options_of_kind) {
        if (option.of_crystals != fabric.has_crystals() && option.is_given(fabric)) throw UsageError(option.message);
    }
    check(fabric.phases);
    check(fabric.strength);
    check(fabric.open);
}

}  // namespace

double equilateral_edge(const Region& region, double n_grains) {
    return std::sqrt(4 * area(region) / (std::numbers::sqrt3 * n_grains));
}

void check_walls(const Request& request, const MeshPlan& plan) {
    const double edge = plan.edge;
    for (const Loop& loop : plan.region.loops) {
        if (loop.circle && loop.circle->radius < smallest_radius * edge) {
            throw UsageError("--" + std::string(request.fabric.edge ? "edge" : "grains") + ": grain edges of " +
                             format_length(edge) + " are too large for a round boundary of radius " +
                             format_length(loop.circle->radius) + "; give smaller grains");
        }
    }
    const auto curves = curves_of({plan.region.name, plan.region.loops, {}});
    for (const Curve& hole : curves) {
        if (hole.kind != Curve::Kind::circular_hole) continue;
        for (const Curve& other : curves) {
            const double wall = other.distance(hole.circle.centre) - hole.circle.radius;
            if (&other == &hole || wall >= thinnest_wall * edge) continue;
            throw UsageError("the rock between a hole of radius " + format_length(hole.circle.radius) +
                             " and the boundary or another hole is " + format_length(wall) + " thick, with grain edges of " +
                             format_length(edge) + "; move the hole, or give smaller grains");
        }
    }
}

void add_edges(const Request& request, MeshPlan& plan) {
    for (std::size_t i = 0; i < request.joint_sets.size(); ++i) {
        const auto joints = joints_of(request.joint_sets[i], request.region, plan.equal_edge, request.seed, i);
        plan.region.edges.insert(plan.region.edges.end(), joints.begin(), joints.end());
    }
    if (plan.region.edges.size() > max_edges) {
        throw UsageError("--flaws: more than " + std::to_string(max_edges) + " flaws and joints; leave some out");
    }
    std::vector<std::string> moves;
    plan.region.edges = fitted_edges(plan.region, plan.equal_edge, &moves);
    for (const std::string& move : moves) plan.warnings.emplace_back(move, "moved_flaw");
    for (const JointSet& set : request.joint_sets) {
        const auto is_of_set = [&set](const PrescribedEdge& e) { return !e.needed && e.name == set.name; };
        if (std::none_of(plan.region.edges.begin(), plan.region.edges.end(), is_of_set)) {
            plan.warnings.emplace_back(
                fmt::format("{}: 0 joints lie in the specimen, with a spacing of {}", set.name, format_length(set.spacing)),
                "no_joints");
        }
    }
}

MeshPlan plan_mesh(const Request& request) {
    const Region& region = request.region;
    check(request.fabric);
    if (is_round(region) && region.loops.front().circle->loaded_diameter >= region.loops.front().circle->diameters) {
        throw UsageError("--loaded-diameter: there are " + std::to_string(region.loops.front().circle->diameters) +
                         " (--diameters), counted from 0");
    }
    MeshPlan plan = request.fabric.has_crystals() ? plan_crystals(request) : plan_triangles(request);
    const std::size_t n_phases = request.fabric.phases.fractions.size();
    if (plan.n_grains < static_cast<std::int64_t>(n_phases)) {
        throw UsageError("--phases: " + std::to_string(n_phases) + " are more than the " + std::to_string(plan.n_grains) +
                         " grains; give at most one phase per grain");
    }
    return plan;
}

TessellatedRegion tessellate(const Request& request, MeshPlan plan, const ProgressCallback& progress) {
    TessellatedRegion made = request.fabric.has_crystals() ? crystals(request, std::move(plan), progress)
                                                           : triangles(request, std::move(plan), progress);
    made.report.warnings = made.plan.warnings;
    made.report.n_flaws = made.plan.region.edges.size();
    for (const PrescribedEdge& e : made.plan.region.edges) made.report.flaw_length += length(e.to - e.from);
    return made;
}

}  // namespace graincrack::mesher
