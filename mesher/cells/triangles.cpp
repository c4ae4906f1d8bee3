#include "mesher/cells/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "mesher/cells/statistics.hpp"
#include "mesher/region/region.hpp"
#include "mesher/seeds/fixed_seeds.hpp"
#include "mesher/seeds/orientation.hpp"
#include "mesher/seeds/sampling.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr int max_attempts = 100;
constexpr int attempts_to_promise = 20;  ///< if the best of so many is far beyond the bounds, further attempts are useless
constexpr int max_corrections = 4;
constexpr std::int64_t max_grains = 700'000'000;  ///< limit by the indices of a specimen file
constexpr double edge_tolerance = 0.005;
constexpr double spread_tolerance = 0.02;   ///< of a spread made by scattered sizes
constexpr double sampling_distance = 0.77;  ///< over the edge; fitted: gives about the requested number of points
constexpr double sampling_margin = 0.7;     ///< distance of the first inner points from the boundary over the edge; by trial
constexpr double outline_spread = 0.7;      ///< spread of outline edges over that of all edges, as outline points are not relaxed

struct Attempt {
    PlaneCells cells;
    double loading_arc = 0;
    MeshReport report;
    double excess = std::numeric_limits<double>::infinity();  ///< psi6 over its bound
    double psi6 = 0;
};

/// Spread that springs leave.
double spring_spread(double spread) { return spread > widest_spring_spread ? tight_spread : spread; }

/// First standard deviation of the logarithm of sizes, which the relaxation adapts: with the spread left by springs it gives the
/// requested one. The factor 1.2 is measured; it makes up for the variation that edges lose as means over their length.
double first_scatter(double spread) {
    return spread > widest_spring_spread ? 1.2 * std::sqrt(spread * spread - tight_spread * tight_spread) : 0;
}

/// Mean edge of equal grains over that of equilateral triangles of the mean area. Fitted to meshes, with an error of 1 %.
double edge_over_equilateral(double spread) {
    const double s = std::clamp(spring_spread(spread), 0.1, 0.18);
    return 1 + 1.15 * s * s - 0.4 * std::max(0.0, s - 0.11);
}

void check_notch(double notch, double width, double edge) {
    if (width < 6 * edge) {
        throw UsageError("--slit: there is no room for one; the specimen must be at least six grain edges of " +
                         format_length(edge) + " wide");
    }
    const bool through = std::abs(notch - width) <= 1e-9 * width;
    if (!through && !(notch >= 2 * edge && notch <= width - 4 * edge)) {
        throw UsageError("--slit: must leave two grain edges of " + format_length(edge) +
                         " at either side and be at least two long; give " + format_length(2 * edge) + " to " +
                         format_length(width - 4 * edge) + ", or " + format_length(width) +
                         " for a joint through the whole width");
    }
}

void check_triangles(const Region& region, const Fabric& fabric) {
    const double smallest = std::min(bounds(region).width(), bounds(region).height());
    if (fabric.edge && *fabric.edge > smallest / 2) {
        throw UsageError("--edge: " + format_length(*fabric.edge) + " is too large for a specimen " + format_length(smallest) +
                         " across; give at most half of that");
    }
    // More grains would exceed the indices of the file for any number of elements.
    if (fabric.edge && area(region) / (*fabric.edge * *fabric.edge) > 3e8) {
        throw UsageError("--edge: " + format_length(*fabric.edge) +
                         " would make more than 700 million grains; choose a larger edge");
    }
    // An equilateral mesh with two edges across the specimen has this many grains.
    const double fewest = std::ceil(16 * area(region) / (std::sqrt(3.0) * smallest * smallest));
    if (fabric.grains && static_cast<double>(*fabric.grains) < fewest) {
        throw UsageError("--grains: " + std::to_string(*fabric.grains) + " is too few for this shape; give at least " +
                         std::to_string(static_cast<std::int64_t>(fewest)));
    }
    if (fabric.grains && *fabric.grains > max_grains) {
        throw UsageError("--grains: at most " + std::to_string(max_grains) + " fit a specimen file");
    }
}

MeshPlan plan_for(const Request& request, std::int64_t n_grains) {
    MeshPlan plan;
    plan.region = request.region;
    const Region& region = plan.region;
    plan.n_grains = n_grains;
    plan.equal_edge = edge_over_equilateral(request.fabric.spread) * equilateral_edge(region, static_cast<double>(n_grains));
    add_edges(request, plan);
    plan.size = SizeField(plan.region, plan.equal_edge, request.fabric.grading, Stretch(request.fabric.elongation),
                          first_scatter(request.fabric.spread));
    plan.edge = plan.equal_edge * plan.size.mean_edge();
    plan.n_boundary = admissible_boundary_count(
        region, relative_perimeter(region, plan.size) / (plan.equal_edge * plan.size.mean_edge_along_lines()), n_grains % 2 != 0);
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

Attempt make_attempt(const Request& request, const MeshPlan& plan, int number, const ProgressCallback& progress) {
    const Stretch& stretch = plan.size.stretch();
    const double edge = plan.equal_edge;
    const Region region = stretched(plan.region, stretch, edge);
    SizeField size = plan.size;
    RandomNumbers random(request.seed, static_cast<std::uint64_t>(number));
    if (size.is_scattered()) size.draw(bounds(region), random);
    const DepthGrid depth(region, sampling_margin * edge * size.largest());
    Seeds fixed =
        fixed_seeds(plan.region, plan.n_boundary, edge, outline_spread * spring_spread(request.fabric.spread), random, size);
    const std::vector<Point> fixed_points = fixed.points;
    for (Point& p : fixed.points) p = stretch.equiaxed(p);
    const auto inner = sample_points(region, depth, sampling_distance * edge, sampling_margin * edge, random, size);
    // Points added to loops, and those on prescribed edges, replace inner points: see `plan_mesh`.
    const auto on_loops = std::count_if(fixed.sides.begin(), fixed.sides.end(), [](const Side& side) { return side.part >= 0; });
    const auto n_free = static_cast<std::ptrdiff_t>(plan.n_inner) - (on_loops - plan.n_boundary) / 2 -
                        (static_cast<std::ptrdiff_t>(fixed.n_fixed) - on_loops);
    if (n_free < 0 && plan.region.loops.size() + plan.region.edges.size() > 1) {
        throw UsageError("--" + std::string(request.fabric.edge ? "edge" : "grains") +
                         ": holes and flaws leave no room for grains of this size; give smaller grains");
    }
    Attempt attempt;
    attempt.loading_arc = plan.region.flats > 0 ? region.flats : fixed.loading_arc;
    const RelaxationGoal goal{edge, request.fabric.spread, static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, n_free))};
    attempt.cells = delaunay_cells(relax_points(depth, std::move(fixed), inner, goal, size, progress));
    measure_edges(plan.region, attempt.cells, size, attempt.report);
    attempt.psi6 = psi6(attempt.cells.points, attempt.cells.edges);
    for (Point& p : attempt.cells.points) p = stretch.elongated(p);
    std::copy(fixed_points.begin(), fixed_points.end(), attempt.cells.points.begin());
    for (const Partition partition : {Partition::blocks, Partition::turned, Partition::bands}) {
        const double largest = largest_psi6_of_parts(plan.region, partition, attempt.cells.points, attempt.cells.edges, stretch);
        attempt.report.psi6_of_parts = std::max(attempt.report.psi6_of_parts, largest);
    }
    attempt.excess = std::max(attempt.psi6 / max_psi6, attempt.report.psi6_of_parts / max_psi6_of_parts);
    if (!is_plain(plan.region) || size.varies()) {
        attempt.excess = std::max(attempt.excess, smallest_angle / attempt.report.min_angle);
    }
    if (size.is_scattered()) {
        attempt.excess = std::max(attempt.excess, std::abs(attempt.report.spread - request.fabric.spread) / spread_tolerance);
    }
    return attempt;
}

/// The first mesh without a preferred direction and slivers and with the requested spread, or the best of all attempts.
Attempt best_attempt(const Request& request, const MeshPlan& plan, const ProgressCallback& progress, int& n_attempts) {
    Attempt best;
    // Small angles at holes and flaws hardly depend on random numbers.
    const int most = is_plain(plan.region) ? max_attempts : 2 * attempts_to_promise;
    for (int number = 0; number < most && best.excess > 1; ++number) {
        if (number >= attempts_to_promise && best.excess > 1.5) break;
        throw_if_interrupted();
        Attempt attempt = make_attempt(request, plan, number, progress);
        ++n_attempts;
        if (attempt.excess < best.excess) best = std::move(attempt);
    }
    return best;
}

}  // namespace

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

MeshPlan plan_triangles(const Request& request) {
    const Region& region = request.region;
    const Fabric& fabric = request.fabric;
    check_triangles(region, fabric);
    if (fabric.grains) return plan_for(request, *fabric.grains);
    const double equilateral = *fabric.edge / edge_over_equilateral(fabric.spread);
    const double n_grains = 4 * area(region) / (std::sqrt(3.0) * equilateral * equilateral);
    MeshPlan plan = plan_for(request, 2 * std::max<std::int64_t>(1, std::llround(n_grains / 2)));
    if (plan.size.is_uniform()) return plan;
    // Varying sizes change the number of grains for a mean edge.
    const double ratio = plan.edge / *fabric.edge;
    return plan_for(request, 2 * std::max<std::int64_t>(1, std::llround(n_grains * ratio * ratio / 2)));
}

TessellatedRegion triangles(const Request& request, MeshPlan plan, const ProgressCallback& progress) {
    const Region& region = request.region;
    const std::optional<double>& edge = request.fabric.edge;
    int n_attempts = 0;
    Attempt attempt = best_attempt(request, plan, progress, n_attempts);
    MeshStatistics statistics = statistics_of(region, attempt.cells);
    for (int i = 0; edge && i < max_corrections; ++i) {
        const double ratio = statistics.mean_edge / *edge;
        const auto n_grains = 2 * std::llround(static_cast<double>(plan.n_grains) * ratio * ratio / 2);
        if (std::abs(ratio - 1) < edge_tolerance || n_grains == plan.n_grains) break;
        MeshPlan next_plan = plan_for(request, n_grains);
        Attempt next = best_attempt(request, next_plan, progress, n_attempts);
        const MeshStatistics next_statistics = statistics_of(region, next.cells);
        if (std::abs(next_statistics.mean_edge / *edge - 1) >= std::abs(ratio - 1)) break;
        plan = std::move(next_plan);
        attempt = std::move(next);
        statistics = next_statistics;
    }
    attempt.report.attempts = n_attempts;
    if (request.fabric.elongation.ratio > 1) statistics.psi6 = attempt.psi6;
    return {std::move(plan), std::move(attempt.cells), attempt.loading_arc, statistics, attempt.report};
}

}  // namespace graincrack::mesher
