#include "mesher/cells/convex_outline.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/plane/constrained_triangulation.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "mesher/seeds/fixed_seeds.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

constexpr int fewest_on_circle = 24;  ///< chords, whose rise is then below 1 % of the radius
/// Where chords differ: none is longer than those of so many equal ones, whose ends have their middle in the circle's to 0.1 % of
/// the diameter.
constexpr int fewest_graded_on_circle = 48;
constexpr double on_line = 1e-9;  ///< sine of the angle below which two sides are one

bool has_arcs(const Loop& loop) {
    return std::any_of(loop.centres.begin(), loop.centres.end(), [](const auto& centre) { return centre.has_value(); });
}

}  // namespace

double outline_count(const Region& region, double edge, const SizeField& size) {
    const Loop& loop = region.loops.front();
    double requested = (size.varies() ? relative_perimeter(region, size) : perimeter(region)) / edge;
    if (loop.circle) requested = std::max({requested, 1.0 * fewest_on_circle, 4.0 * loop.circle->diameters});
    if (has_arcs(loop)) requested = std::max(requested, 1.0 * fewest_on_circle);
    if (size.varies() && (loop.circle || has_arcs(loop))) {
        const double around = perimeter({region.name, {loop}, {}, region.part_names, region.flats});
        requested = std::max(requested, fewest_graded_on_circle * size.largest() * std::sqrt(size.stretch().ratio()) *
                                      relative_perimeter(region, size) / around);
    }
    return requested;
}

ConvexOutline convex_outline(const Region& region, double edge, const SizeField& size) {
    RandomNumbers random(0);  // of which equal distances need none
    const int count = admissible_boundary_count(region, outline_count(region, edge, size), false);
    const Seeds seeds = fixed_seeds(region, count, edge, 0, random, size);

    ConvexOutline outline;
    outline.loading_arc = region.flats > 0 ? region.flats : seeds.loading_arc;
    const std::size_t n = seeds.sides.size();
    const auto at = [&](int p) { return seeds.points[static_cast<std::size_t>(p)]; };
    for (std::size_t i = 0; i < n; ++i) {
        const Side& before = seeds.sides[(i + n - 1) % n];
        const Side& side = seeds.sides[i];
        const Point u = at(before.to) - at(before.from);
        const Point v = at(side.to) - at(side.from);
        if (before.part == side.part && std::abs(cross(u, v)) < on_line * length(u) * length(v)) continue;
        outline.corners.push_back(at(side.from));
        outline.parts.push_back(static_cast<std::uint8_t>(side.part));
    }
    if (!is_convex(outline.corners)) {
        throw UsageError("--tessellation: the round sides of this shape do not make a convex polygon; give smaller grains");
    }
    return outline;
}

PolygonMoments moments(const std::vector<Point>& corners) {
    PolygonMoments result;
    const Point origin = corners.front();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const double area = signed_area(origin, corners[i], corners[i + 1]);
        result.area += area;
        result.centroid = result.centroid + (area / 3) * ((corners[i] - origin) + (corners[i + 1] - origin));
    }
    result.centroid = origin + (1 / result.area) * result.centroid;
    return result;
}

}  // namespace graincrack::mesher
