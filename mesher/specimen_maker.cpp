#include "mesher/specimen_maker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "mesher/assemblage/notch.hpp"
#include "mesher/assemblage/separate_bodies.hpp"
#include "mesher/assemblage/statistics.hpp"
#include "mesher/cells/convex_outline.hpp"
#include "mesher/cells/delaunay.hpp"
#include "mesher/elements/lattice.hpp"
#include "mesher/fabric/crystals.hpp"
#include "mesher/plane/refined_triangulation.hpp"
#include "mesher/region/fit_edges.hpp"
#include "mesher/region/stretched_region.hpp"
#include "mesher/seeds/fixed_seeds.hpp"
#include "mesher/seeds/orientation.hpp"
#include "mesher/seeds/sampling.hpp"
#include "share/base/error.hpp"
#include "share/base/quantities.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::size_t max_edges = 3000;  ///< prescribed; each is compared with each
constexpr std::int64_t max_polygons = 1'000'000;
constexpr double max_elements_of_polygons = 15e6;
constexpr int max_attempts = 100;
constexpr int attempts_to_promise = 20;  ///< if the best of so many is far above the bounds, further attempts are useless
constexpr int max_corrections = 4;
constexpr double smallest_radius = 0.9;  ///< of a round boundary, over the edge: a polygon of five edges or so
constexpr double thinnest_wall = 0.5;    ///< between round holes and the boundary, over the edge
constexpr double edge_tolerance = 0.005;
constexpr double element_count_tolerance = 0.02;  ///< of a requested number of elements a polygon
constexpr int max_element_trials = 8;
constexpr std::size_t polygons_of_trial = 500;
constexpr double spread_tolerance = 0.02;   ///< of a spread that is made by sizes that scatter
constexpr double sampling_distance = 0.77;  ///< over the edge: gives about the requested number of points
constexpr double sampling_margin = 0.7;     ///< over the edge: distance of the first row of inner points from the boundary
constexpr double outline_spread =
    0.7;  ///< spread of the outline's edges over that of all edges: points of the outline are not relaxed

struct Attempt {
    PlaneCells cells;
    double loading_arc = 0;
    SizeStatistics sizes;
    double excess = std::numeric_limits<double>::infinity();  ///< psi6 over its bound
    double psi6 = 0;
    double psi6_of_parts = 0;
};

/// Spread that springs are to leave.
double spring_spread(double spread) { return spread > widest_spring_spread ? tight_spread : spread; }

/// First standard deviation of the logarithm of sizes, which the relaxation adapts: with the spread that springs leave it makes
/// the wanted one. The factor, as measured, is for what edges lose as means over their length.
double first_scatter(double spread) {
    return spread > widest_spring_spread ? 1.2 * std::sqrt(spread * spread - tight_spread * tight_spread) : 0;
}

/// Mean edge over that of equilateral triangles of the mean area, of equal grains; measured, good to 1 %.
double edge_over_equilateral(double spread) {
    const double s = std::clamp(spring_spread(spread), 0.1, 0.18);
    return 1 + 1.15 * s * s - 0.4 * std::max(0.0, s - 0.11);
}

double smallest_extent(const Region& region) { return std::min(bounds(region).width(), bounds(region).height()); }

bool are_polygons(const SpecimenRequest& request) { return request.tessellation != Tessellation::delaunay; }

/// What triangles and polygons have in common.
void check_common(const SpecimenRequest& request) {
    check(request.region);
    if (request.edge.has_value() == request.grains.has_value()) {
        throw UsageError(
            "give exactly one of --edge (mean edge), --grains (number of grains) and --grain-size, or a --material whose "
            "[fabric] has a grain_size");
    }
    const double widest = are_polygons(request) ? max_spread_of_polygons : max_spread;
    if (!(request.spread >= 0 && request.spread <= widest)) {
        throw UsageError("--spread: " + format_number(request.spread) + " is out of range; give 0 to " + format_number(widest));
    }
    if (request.edge && (!(*request.edge > 0) || !std::isfinite(*request.edge))) {
        throw UsageError("--edge: must be a length above 0");
    }
    const Region& region = request.region;
    if (is_round(region) && region.loops.front().circle->loaded_diameter >= region.loops.front().circle->diameters) {
        throw UsageError("--loaded-diameter: there are " + std::to_string(region.loops.front().circle->diameters) +
                         " (--diameters), counted from 0");
    }
    if (!(request.elongation.ratio >= 1 && request.elongation.ratio <= max_elongation)) {
        throw UsageError("--elongation: " + format_number(request.elongation.ratio) + " is out of range; give 1 to " +
                         format_number(max_elongation));
    }
    check(request.phases);
    check(request.strength);
    check(request.open);
}

void check_request(const SpecimenRequest& request) {
    const Region& region = request.region;
    if (request.elements_per_crystal) {
        throw UsageError("--elements-per-crystal: is for polygons; give --elements-per-edge, or --tessellation voronoi");
    }
    if (request.element_size) {
        throw UsageError("--element-size: is for polygons; give --elements-per-edge, or --tessellation voronoi");
    }
    if (request.size_distribution) {
        throw UsageError("--size-distribution: is for polygons; give --tessellation voronoi or trigon");
    }
    if (request.elements_per_edge < 1 || request.elements_per_edge > max_elements_per_edge) {
        throw UsageError("--elements-per-edge: must be 1 to " + std::to_string(max_elements_per_edge));
    }
    const double smallest = smallest_extent(region);
    if (request.edge) {
        if (*request.edge > smallest / 2) {
            throw UsageError("--edge: " + format_length(*request.edge) + " is too large for a specimen " +
                             format_length(smallest) + " across; give at most half of that");
        }
        // More grains than this would exceed the file's indices, whatever the number of elements.
        if (area(region) / (*request.edge * *request.edge) > 3e8) {
            throw UsageError("--edge: " + format_length(*request.edge) +
                             " would make more than 700 million grains; choose a larger edge");
        }
    }
}

void check_notch(double notch, double width, double edge) {
    if (width < 6 * edge) {
        throw UsageError("--notch: there is no room for one; the specimen must be at least six grain edges of " +
                         format_length(edge) + " wide");
    }
    const bool through = std::abs(notch - width) <= 1e-9 * width;
    if (!through && !(notch >= 2 * edge && notch <= width - 4 * edge)) {
        throw UsageError("--notch: must leave two grain edges of " + format_length(edge) +
                         " at either side and be at least two long; give " + format_length(2 * edge) + " to " +
                         format_length(width - 4 * edge) + ", or " + format_length(width) +
                         " for a joint through the whole width");
    }
}

/// Round boundaries must not be small for the grains, which must have room between a round hole and the boundary or another.
void check_walls(const SpecimenRequest& request, const MeshPlan& plan) {
    const double edge = plan.edge;
    for (const Loop& loop : plan.region.loops) {
        if (loop.circle && loop.circle->radius < smallest_radius * edge) {
            throw UsageError("--" + std::string(request.edge ? "edge" : "grains") + ": grain edges of " + format_length(edge) +
                             " are too large for a round boundary of radius " + format_length(loop.circle->radius) +
                             "; give smaller grains");
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

/// Adds the joints of sets, and fits all prescribed edges to the grains.
void add_edges(const SpecimenRequest& request, MeshPlan& plan) {
    for (std::size_t i = 0; i < request.joint_sets.size(); ++i) {
        const auto joints = joints_of(request.joint_sets[i], request.region, plan.equal_edge, request.seed, i);
        plan.region.edges.insert(plan.region.edges.end(), joints.begin(), joints.end());
    }
    if (plan.region.edges.size() > max_edges) {
        throw UsageError("--flaws: more than " + std::to_string(max_edges) + " flaws and joints; leave some out");
    }
    plan.region.edges = fitted_edges(plan.region, plan.equal_edge);
}

void check_number_of_phases(const SpecimenRequest& request, std::int64_t n_grains) {
    const std::size_t n_phases = request.phases.fractions.size();
    if (n_grains >= static_cast<std::int64_t>(n_phases)) return;
    throw UsageError("--phases: " + std::to_string(n_phases) + " are more than the " + std::to_string(n_grains) +
                     " grains; give at most one phase per grain");
}

/// Checks what is of polygons alone, and that no option is given that polygons do not have.
MeshPlan plan_polygons(const SpecimenRequest& request) {
    const auto refuse = [](const std::string& option, const char* why) {
        throw UsageError(option + ": " + why + "; leave it out, or give --tessellation delaunay");
    };
    if (request.elements_per_edge != 1) refuse("--elements-per-edge", "polygons have elements of --element-size");
    MeshPlan plan;
    plan.region = request.region;
    plan.n_grains = request.grains
                        ? *request.grains
                        : static_cast<std::int64_t>(std::min(
                              std::round(4 * area(plan.region) / (std::sqrt(3.0) * *request.edge * *request.edge)), 1e18));
    const std::string option = request.grains ? "--grains: " : "--edge: ";
    if (plan.n_grains < 2) {
        throw UsageError(option + "polygons are at least two; give " + (request.grains ? "2" : "a smaller edge"));
    }
    if (plan.n_grains > max_polygons) {
        throw UsageError(option + std::to_string(plan.n_grains) + " polygons are too many; at most " +
                         std::to_string(max_polygons) + " are made");
    }
    plan.edge = plan.equal_edge = equilateral_edge(plan.region, static_cast<double>(plan.n_grains));
    plan.element_size = request.element_size.value_or(element_over_edge * plan.edge);
    if (request.elements_per_crystal) {
        const double n_elements = *request.elements_per_crystal * static_cast<double>(plan.n_grains);
        plan.element_size = std::sqrt(triangles_of_square * area(plan.region) / n_elements);
    }
    const double n_elements = triangles_of_square * area(plan.region) / (plan.element_size * plan.element_size);
    if (!(n_elements <= max_elements_of_polygons)) {
        throw UsageError("--element-size: " + format_length(plan.element_size) + " would make more than " +
                         std::to_string(static_cast<std::int64_t>(max_elements_of_polygons)) + " elements; at least " +
                         format_length(std::sqrt(triangles_of_square * area(plan.region) / max_elements_of_polygons)) +
                         " is needed");
    }
    check_number_of_phases(request, plan.n_grains);
    if (request.notch) plan.region.edges.push_back(central_slit(plan.region, *request.notch, 0, "--notch"));
    add_edges(request, plan);
    if (request.grading) plan.size = SizeField(plan.region, plan.edge, request.grading, Stretch(request.elongation), 0);
    if (!is_plain(plan.region)) check_walls(request, plan);
    if (is_plain(plan.region)) (void)convex_outline(plan.region, plan.edge, plan.size);
    return plan;
}

MeshPlan plan_for(const SpecimenRequest& request, std::int64_t n_grains) {
    MeshPlan plan;
    plan.region = request.region;
    const Region& region = plan.region;
    plan.n_grains = n_grains;
    plan.equal_edge = edge_over_equilateral(request.spread) * equilateral_edge(region, static_cast<double>(n_grains));
    add_edges(request, plan);
    plan.size =
        SizeField(plan.region, plan.equal_edge, request.grading, Stretch(request.elongation), first_scatter(request.spread));
    plan.edge = plan.equal_edge * plan.size.mean_edge();
    plan.n_boundary = admissible_boundary_count(
        region, relative_perimeter(region, plan.size) / (plan.equal_edge * plan.size.mean_edge_along_lines()), n_grains % 2 != 0);
    check_number_of_phases(request, n_grains);
    const int diameters = is_round(region) ? region.loops.front().circle->diameters : 1;
    if (plan.n_boundary < 4 * diameters) {
        throw UsageError("--diameters: " + std::to_string(diameters) + " are too many for " + std::to_string(plan.n_boundary) +
                         " edges on the rim; give at most a quarter of that number");
    }
    if (request.notch) check_notch(*request.notch, bounds(region).width(), plan.edge);
    check_walls(request, plan);
    const auto n_holes = static_cast<std::int64_t>(region.loops.size()) - 1;
    plan.n_inner = static_cast<std::size_t>(std::max<std::int64_t>(0, (n_grains + 2 - 2 * n_holes - plan.n_boundary) / 2));
    return plan;
}

Attempt make_attempt(const SpecimenRequest& request, const MeshPlan& plan, int number, const ProgressCallback& progress) {
    const Stretch& stretch = plan.size.stretch();
    const double edge = plan.equal_edge;
    const Region region = stretched(plan.region, stretch, edge);
    SizeField size = plan.size;
    RandomNumbers random(request.seed, static_cast<std::uint64_t>(number));
    if (size.is_scattered()) size.draw(bounds(region), random);
    const DepthGrid depth(region, sampling_margin * edge * size.largest());
    Seeds fixed = fixed_seeds(plan.region, plan.n_boundary, edge, outline_spread * spring_spread(request.spread), random, size);
    const std::vector<Point> fixed_points = fixed.points;
    for (Point& p : fixed.points) p = stretch.equiaxed(p);
    const auto inner = sample_points(region, depth, sampling_distance * edge, sampling_margin * edge, random, size);
    // Points added to loops, and those on prescribed edges, stand for inner points: see `plan_mesh`.
    const auto on_loops = std::count_if(fixed.sides.begin(), fixed.sides.end(), [](const Side& side) { return side.part >= 0; });
    const auto n_free = static_cast<std::ptrdiff_t>(plan.n_inner) - (on_loops - plan.n_boundary) / 2 -
                        (static_cast<std::ptrdiff_t>(fixed.n_fixed) - on_loops);
    if (n_free < 0 && plan.region.loops.size() + plan.region.edges.size() > 1) {
        throw UsageError("--" + std::string(request.edge ? "edge" : "grains") +
                         ": holes and flaws leave no room for grains of this size; give smaller grains");
    }
    Attempt attempt;
    attempt.loading_arc = plan.region.flats > 0 ? region.flats : fixed.loading_arc;
    const RelaxationGoal goal{edge, request.spread, static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, n_free))};
    attempt.cells = delaunay_cells(relax_points(depth, std::move(fixed), inner, goal, size, progress));
    attempt.sizes = size_statistics_of(plan.region, attempt.cells, size, edge, request.grading);
    attempt.psi6 = psi6(attempt.cells.points, attempt.cells.edges);
    for (Point& p : attempt.cells.points) p = stretch.elongated(p);
    std::copy(fixed_points.begin(), fixed_points.end(), attempt.cells.points.begin());
    for (const Partition partition : {Partition::blocks, Partition::turned, Partition::bands}) {
        const double largest = largest_psi6_of_parts(plan.region, partition, attempt.cells.points, attempt.cells.edges, stretch);
        attempt.psi6_of_parts = std::max(attempt.psi6_of_parts, largest);
    }
    attempt.excess = std::max(attempt.psi6 / max_psi6, attempt.psi6_of_parts / max_psi6_of_parts);
    if (!is_plain(plan.region) || size.varies()) {
        attempt.excess = std::max(attempt.excess, smallest_angle / attempt.sizes.min_angle);
    }
    if (size.is_scattered()) {
        attempt.excess = std::max(attempt.excess, std::abs(attempt.sizes.spread - request.spread) / spread_tolerance);
    }
    return attempt;
}

/// The first mesh without a preferred direction, without slivers and with the wanted spread, or the best of all attempts.
Attempt best_attempt(const SpecimenRequest& request, const MeshPlan& plan, const ProgressCallback& progress, MeshReport& report) {
    Attempt best;
    // Where holes and flaws make a small angle, it hardly depends on random numbers.
    const int most = is_plain(plan.region) ? max_attempts : 2 * attempts_to_promise;
    for (int number = 0; number < most && best.excess > 1; ++number) {
        if (number >= attempts_to_promise && best.excess > 1.5) break;
        throw_if_interrupted();
        Attempt attempt = make_attempt(request, plan, number, progress);
        ++report.attempts;
        if (attempt.excess < best.excess) best = std::move(attempt);
    }
    report.psi6_of_parts = best.psi6_of_parts;
    return best;
}

/// What a specimen is.
void describe(Specimen& specimen, const Region& region) {
    specimen.shape = region.name;
    specimen.width = bounds(region).width();
    specimen.height = bounds(region).height();
    specimen.part_names = region.part_names;
}

void count_flaws(const Region& region, MeshReport& report) {
    report.n_flaws = region.edges.size();
    for (const PrescribedEdge& e : region.edges) report.flaw_length += length(e.to - e.from);
}

void give_fabric(Specimen& specimen, const std::vector<int>& crystal_of_grain, const SpecimenRequest& request) {
    specimen.seed = request.seed;
    assign_phases(specimen, crystal_of_grain, request.phases);
    assign_strength_factors(specimen, crystal_of_grain, turn_to_load(request.region), request.strength);
    open_boundaries(specimen, crystal_of_grain, request.open);
}

/// The size of elements that gives a polygon as many of them as are wanted, tried on some polygons of these sizes: their corners
/// ask for elements of their own, so that the number is not that of the size alone.
double element_size_for(PolygonRequest polygons, Region region, double elements_per_crystal) {
    if (polygons.n > polygons_of_trial) {
        const double side = std::sqrt(area(region) * polygons_of_trial / static_cast<double>(polygons.n));
        region = rectangle(side, side);
        centre_region(region);
        polygons.n = polygons_of_trial;
        polygons.grading.reset();  // crystals have as many elements everywhere
        polygons.size = {};
    }
    for (int i = 0; i < max_element_trials; ++i) {
        const auto n_elements = static_cast<double>(polygon_mesh(region, polygons).mesh.triangles.size());
        const double ratio = n_elements / (elements_per_crystal * static_cast<double>(polygons.n));
        if (std::abs(ratio - 1) < element_count_tolerance) break;
        polygons.element_size *= std::sqrt(ratio);
    }
    return polygons.element_size;
}

Specimen make_polygons(const SpecimenRequest& request, const MeshPlan& plan, const ProgressCallback& progress,
                       MeshReport& report) {
    const Region& region = plan.region;
    const bool can_break = request.tessellation == Tessellation::trigon;
    PolygonRequest polygons;
    polygons.n = static_cast<std::size_t>(plan.n_grains);
    polygons.spread = request.spread;
    polygons.distribution = request.size_distribution.value_or(SizeDistribution::normal);
    polygons.element_size = plan.element_size;
    polygons.are_elements_graded = !request.element_size;
    polygons.bodies = can_break ? Bodies::triangles : Bodies::cells;
    polygons.elongation = request.elongation;
    polygons.grading = request.grading;
    polygons.size = plan.size;
    polygons.seed = request.seed;
    if (request.elements_per_crystal) polygons.element_size = element_size_for(polygons, region, *request.elements_per_crystal);
    PolygonMesh made = polygon_mesh(region, polygons, progress);
    report.polygons = made.statistics;
    report.sizes.spread = made.statistics.diameter_variation;
    count_flaws(region, report);
    turn_to_load(region, made.mesh.points);
    std::vector<int> crystal_of_grain;
    Specimen specimen = separate_bodies(made.mesh, &crystal_of_grain);
    specimen.tessellation = can_break ? "trigon" : "voronoi";
    specimen.loading_arc = made.loading_arc;
    describe(specimen, region);
    specimen.statistics = statistics_of(specimen);
    const double total = std::accumulate(specimen.grain_area.begin(), specimen.grain_area.end(), 0.0);
    specimen.statistics.area_error = total / area(region) - 1;
    if (request.elongation.ratio > 1) {
        specimen.statistics.elongation = made.statistics.elongation.ratio;
        specimen.statistics.elongation_angle = made.statistics.elongation.angle;
    }
    give_fabric(specimen, crystal_of_grain, request);
    if (can_break) name_crystals(specimen, crystal_of_grain);
    return specimen;
}

}  // namespace

MeshPlan plan_mesh(const SpecimenRequest& request) {
    check_common(request);
    if (are_polygons(request)) return plan_polygons(request);
    check_request(request);
    const Region& region = request.region;
    if (!request.grains) {
        const double equilateral = *request.edge / edge_over_equilateral(request.spread);
        const double n_grains = 4 * area(region) / (std::sqrt(3.0) * equilateral * equilateral);
        MeshPlan plan = plan_for(request, 2 * std::max<std::int64_t>(1, std::llround(n_grains / 2)));
        // Of sizes that differ it takes more grains or fewer.
        if (!plan.size.is_uniform()) {
            const double ratio = plan.edge / *request.edge;
            plan = plan_for(request, 2 * std::max<std::int64_t>(1, std::llround(n_grains * ratio * ratio / 2)));
        }
        return plan;
    }
    const double smallest = smallest_extent(region);
    // With at least two edges across the specimen (`check_request`), an equilateral mesh has this many grains.
    const double fewest = std::ceil(16 * area(region) / (std::sqrt(3.0) * smallest * smallest));
    if (static_cast<double>(*request.grains) < fewest) {
        throw UsageError("--grains: " + std::to_string(*request.grains) + " is too few for this shape; give at least " +
                         std::to_string(static_cast<std::int64_t>(fewest)));
    }
    if (*request.grains > 700'000'000) throw UsageError("--grains: at most 700000000 fit a specimen file");
    return plan_for(request, *request.grains);
}

Specimen make_specimen(const SpecimenRequest& request, const ProgressCallback& progress, MeshReport* report) {
    MeshPlan plan = plan_mesh(request);
    MeshReport made;
    if (are_polygons(request)) {
        Specimen polygons = make_polygons(request, plan, progress, made);
        if (report != nullptr) *report = made;
        return polygons;
    }
    Attempt attempt = best_attempt(request, plan, progress, made);
    const Region& region = request.region;
    MeshStatistics statistics = statistics_of(region, attempt.cells);
    for (int i = 0; request.edge && i < max_corrections; ++i) {
        const double ratio = statistics.mean_edge / *request.edge;
        const auto n_grains = 2 * std::llround(static_cast<double>(plan.n_grains) * ratio * ratio / 2);
        if (std::abs(ratio - 1) < edge_tolerance || n_grains == plan.n_grains) break;
        const MeshPlan next_plan = plan_for(request, n_grains);
        Attempt next = best_attempt(request, next_plan, progress, made);
        const MeshStatistics next_statistics = statistics_of(region, next.cells);
        if (std::abs(next_statistics.mean_edge / *request.edge - 1) >= std::abs(ratio - 1)) break;
        plan = next_plan;
        attempt = std::move(next);
        statistics = next_statistics;
    }
    made.psi6_of_parts = attempt.psi6_of_parts;
    made.sizes = attempt.sizes;
    count_flaws(plan.region, made);
    turn_to_load(region, attempt.cells.points);
    if (request.elongation.ratio > 1) {
        statistics.psi6 = attempt.psi6;
        const Elongation measured = elongation_of(attempt.cells);
        statistics.elongation = measured.ratio;
        statistics.elongation_angle = measured.angle;
    }
    std::vector<int> crystal_of_grain;
    Specimen specimen = separate_bodies(lattice_mesh(std::move(attempt.cells), request.elements_per_edge), &crystal_of_grain);
    specimen.tessellation = "delaunay";
    specimen.elements_per_edge = request.elements_per_edge;
    specimen.loading_arc = attempt.loading_arc;
    describe(specimen, region);
    if (request.notch) cut_notch(specimen, *request.notch);
    specimen.statistics = statistics;
    give_fabric(specimen, crystal_of_grain, request);
    if (report != nullptr) *report = made;
    return specimen;
}

}  // namespace graincrack::mesher
