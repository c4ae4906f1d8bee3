#include "mesher/cells/walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "mesher/plane/triangulation.hpp"
#include "mesher/seeds/fixed_seeds.hpp"

namespace graincrack::mesher {

namespace {

constexpr double on_one_line = 1e-9;  ///< sine of the angle below which two sides are collinear

// Triangles over which sizes are integrated:
constexpr double even_sizes = 0.1;  ///< relative change of size up to which a triangle is not divided
constexpr int fewest_divisions = 3;
constexpr int most_divisions = 9;

/// Number of rim points with which flaws that move them shift the middle of the polygon by at most 0.1 % of the diameter.
constexpr double fewest_on_rim = 48;

constexpr int fewest_on_circle = 24;  ///< chords, whose rise is below 1 % of the radius
/// Bound for unequal chords: none is longer than those of so many equal ones, whose middle is the circle's to 0.1 % of the
/// diameter.
constexpr int fewest_graded_on_circle = 48;

bool has_arcs(const Loop& loop) {
    return std::any_of(loop.centres.begin(), loop.centres.end(), [](const auto& centre) { return centre.has_value(); });
}

/// Number of points on the loops of a region, about `edge` times the local size apart, and more on small round loops.
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

ConvexOutline box_around(const std::vector<Point>& points, double margin) {
    const Box box = box_of(points);
    const Point low = box.low - Point{margin, margin};
    const Point high = box.high + Point{margin, margin};
    return {{low, {high.x, low.y}, high, {low.x, high.y}}, {0, 0, 0, 0}};
}

/// Integral of one over the squared graded size over a triangle, which is divided until its size hardly varies.
double graded_integral(Point a, Point b, Point c, const SizeField& size, int depth) {
    const Point ab = midpoint(a, b);
    const Point bc = midpoint(b, c);
    const Point ca = midpoint(c, a);
    double sum = 0;
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0;
    for (const Point p : {ab, bc, ca}) {
        const double g = size.graded(p);
        least = std::min(least, g);
        greatest = std::max(greatest, g);
        sum += 1 / (3 * g * g);
    }
    const bool is_even = greatest < (1 + even_sizes) * least && depth >= fewest_divisions;
    if (is_even || depth == most_divisions) return sum * signed_area(a, b, c);
    return graded_integral(a, ab, ca, size, depth + 1) + graded_integral(ab, b, bc, size, depth + 1) +
           graded_integral(ca, bc, c, size, depth + 1) + graded_integral(ab, bc, ca, size, depth + 1);
}

/// True if two segments share an inner point of both.
bool do_cross(Point a, Point b, Point c, Point d) {
    return signed_area(a, b, c) * signed_area(a, b, d) <= 0 && signed_area(c, d, a) * signed_area(c, d, b) <= 0;
}

/// The region without holes and prescribed edges.
Region outline_of(const Region& region) { return {region.name, {region.loops.front()}, {}, region.part_names, region.flats}; }

/// Points on the loops at equal distances, and ends and meetings of prescribed edges.
Seeds seeds_of_walls(const Region& region, double edge, const SizeField& size) {
    double requested = outline_count(region, edge, size);
    if (is_round(region) && !is_plain(region)) {
        requested = std::max(requested, fewest_on_rim * perimeter(region) / perimeter(outline_of(region)));
    }
    RandomNumbers random(0);  // unused by equal distances
    const int n = admissible_boundary_count(region, requested, false);
    return fixed_seeds(region, n, std::numeric_limits<double>::infinity(), 0, random, size);
}

}  // namespace

double nearest_fraction(Point p, Point from, Point to) {
    return std::clamp(dot(p - from, to - from) / squared_length(to - from), 0.0, 1.0);
}

bool Walls::contains(Point p) const {
    bool inside = false;
    for (const Side& side : sides) {
        if (side.part < 0) continue;
        const Point a = at(side.from);
        const Point b = at(side.to);
        if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

Walls walls_of(const Region& region, double edge, const Stretch& stretch, const SizeField& size) {
    const Region plain = outline_of(region);
    Walls walls;
    walls.is_convex = is_plain(plain);
    const Seeds seeds = seeds_of_walls(region, edge, size);
    walls.loading_arc = region.flats > 0 ? region.flats : seeds.loading_arc;
    std::vector<char> is_end(seeds.points.size(), 0);
    for (const Side& side : seeds.sides) {
        if (side.part < 0) is_end[index(side.from)] = is_end[index(side.to)] = 1;
    }
    std::vector<int> number(seeds.points.size(), -1);
    const auto point = [&](int p) {
        int& known = number[index(p)];
        if (known < 0) {
            known = static_cast<int>(walls.points.size());
            walls.points.push_back(seeds.points[index(p)]);
        }
        return known;
    };
    const auto at = [&](int p) { return seeds.points[index(p)]; };
    // Points inside straight sides of loops are omitted.
    const std::size_t n_loop_sides = static_cast<std::size_t>(
        std::count_if(seeds.sides.begin(), seeds.sides.end(), [](const Side& side) { return side.part >= 0; }));
    for (std::size_t first = 0; first < n_loop_sides;) {
        std::size_t end = first + 1;
        while (end < n_loop_sides && seeds.sides[end - 1].to == seeds.sides[end].from) ++end;
        std::vector<Side> kept;
        std::vector<char> is_corner;
        for (std::size_t i = first; i < end; ++i) {
            const Side& before = seeds.sides[i == first ? end - 1 : i - 1];
            const Side& side = seeds.sides[i];
            const Point u = at(before.to) - at(before.from);
            const Point v = at(side.to) - at(side.from);
            const bool is_straight = before.part == side.part && std::abs(cross(u, v)) < on_one_line * length(u) * length(v);
            if (is_straight && is_end[index(side.from)] == 0) continue;
            kept.push_back(side);
            is_corner.push_back(is_straight ? 0 : 1);
        }
        for (std::size_t i = 0; i < kept.size(); ++i) {
            walls.sides.push_back({point(kept[i].from), point(kept[(i + 1) % kept.size()].from), kept[i].part, {}});
            if (first > 0 || !walls.is_convex || is_corner[i] == 0) continue;
            walls.hull.corners.push_back(at(kept[i].from));
            walls.hull.parts.push_back(static_cast<std::uint8_t>(kept[i].part));
        }
        first = end;
    }
    for (std::size_t i = n_loop_sides; i < seeds.sides.size(); ++i) {
        const Side& side = seeds.sides[i];
        walls.sides.push_back({point(side.from), point(side.to), -1, side.kind});
    }
    if (walls.is_convex && !is_convex(walls.hull.corners)) walls.is_convex = false;
    for (auto* points : {&walls.points, &walls.hull.corners}) {
        for (Point& p : *points) p = stretch.equiaxed(p);
    }
    if (!walls.is_convex) walls.hull = box_around(walls.points, edge);
    return walls;
}

std::size_t Walls::n_sides_of_outline() const {
    std::size_t n = 1;
    while (sides[n - 1].to != sides.front().from) ++n;
    return n;
}

Zones::Zones(const Walls& walls) : walls_(walls) {
    std::vector<Point> points = walls.points;
    std::vector<Edge> around;
    std::vector<Edge> inner;
    std::set<Edge> borders;
    if (!walls.is_convex) {
        const int n = static_cast<int>(points.size());
        points.insert(points.end(), walls.hull.corners.begin(), walls.hull.corners.end());
        for (int k = 0; k < 4; ++k) around.push_back(edge_between(n + k, n + (k + 1) % 4));
    }
    for (std::size_t i = 0; i < walls.sides.size(); ++i) {
        const Side& side = walls.sides[i];
        const bool is_outer = walls.is_convex && i < walls.n_sides_of_outline();
        const Edge edge = edge_between(side.from, side.to);
        (is_outer ? around : inner).push_back(edge);
        borders.insert(edge);
        segments_.push_back({walls.at(side.from), walls.at(side.to), !is_outer});
    }
    const std::vector<Triangle> triangles = constrained_triangles(points, around, inner);
    std::map<Edge, std::vector<std::size_t>> beside;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) beside[edge_between(triangles[t][k], triangles[t][(k + 1) % 3])].push_back(t);
    }
    constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> zone_of(triangles.size(), unknown);
    std::vector<std::size_t> reached;
    for (std::size_t start = 0; start < triangles.size(); ++start) {
        if (zone_of[start] != unknown) continue;
        const std::size_t zone = areas_.size();
        areas_.push_back(0);
        zone_of[start] = zone;
        reached.assign(1, start);
        while (!reached.empty()) {
            const Triangle& t = triangles[reached.back()];
            reached.pop_back();
            const auto corner = [&](std::size_t k) { return points[index(t[k])]; };
            faces_.push_back({{corner(0), corner(1), corner(2)}, zone});
            areas_[zone] += signed_area(corner(0), corner(1), corner(2));
            for (std::size_t k = 0; k < 3; ++k) {
                const Edge edge = edge_between(t[k], t[(k + 1) % 3]);
                if (borders.count(edge) > 0) continue;
                for (const std::size_t next : beside[edge]) {
                    if (zone_of[next] != unknown) continue;
                    zone_of[next] = zone;
                    reached.push_back(next);
                }
            }
        }
        const Face& some = faces_.back();
        is_inside_.push_back(walls.contains((1.0 / 3) * (some.corners[0] + some.corners[1] + some.corners[2])) ? 1 : 0);
    }
}

double Zones::graded_area(std::size_t zone, const SizeField& size) const {
    if (!size.varies()) return areas_[zone];
    double sum = 0;
    for (const Face& face : faces_) {
        if (face.zone == zone) sum += graded_integral(face.corners[0], face.corners[1], face.corners[2], size, 0);
    }
    return sum;
}

std::size_t Zones::zone_at(Point p) const {
    const auto found = std::find_if(faces_.begin(), faces_.end(), [p](const Face& face) {
        const auto& [a, b, c] = face.corners;
        return signed_area(a, b, p) >= 0 && signed_area(b, c, p) >= 0 && signed_area(c, a, p) >= 0;
    });
    return found == faces_.end() ? size() : found->zone;
}

Point Zones::random_point(std::size_t zone, RandomNumbers& random) const {
    double rest = random.uniform() * areas_[zone];
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const Face* chosen = nullptr;
    for (const Face& face : faces_) {
        if (face.zone != zone) continue;
        chosen = &face;
        rest -= signed_area(face.corners[0], face.corners[1], face.corners[2]);
        if (rest < 0) break;
    }
    const auto& [a, b, c] = chosen->corners;
    return a + u * (b - a) + v * (c - a);
}

bool Zones::is_free(Point from, Point to) const {
    if (!walls_.is_convex) {
        const Point low = walls_.hull.corners[0];
        const Point high = walls_.hull.corners[2];
        if (!(to.x > low.x && to.y > low.y && to.x < high.x && to.y < high.y)) return false;
    }
    return std::none_of(segments_.begin(), segments_.end(), [&](const Segment& s) { return do_cross(from, to, s.from, s.to); });
}

Point Zones::moved(Point from, Point to, double distance) const {
    const Point goal = is_free(from, to) ? to : from;
    double least = std::numeric_limits<double>::infinity();
    Point nearest;
    for (const Segment& s : segments_) {
        if (!s.is_inner) continue;
        const Point foot = s.from + nearest_fraction(goal, s.from, s.to) * (s.to - s.from);
        if (squared_length(goal - foot) < least) {
            least = squared_length(goal - foot);
            nearest = foot;
        }
    }
    if (least >= distance * distance || least == 0) return goal;
    const Point off = nearest + distance * unit(goal - nearest);
    return is_free(from, off) ? off : goal;
}

}  // namespace graincrack::mesher
