#include "mesher/region/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/plane/constrained_triangulation.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

constexpr double pi = std::numbers::pi;
// Corners between these angles belong to two grains; sharper ones are the corner of one, blunter ones are shared anyway.
const double sharpest_shared = std::cos(75 * pi / 180);
const double bluntest_shared = std::cos(150 * pi / 180);
constexpr double round_off = 1e-12;  ///< of the extent of a region

/// Calls `visit(from, to)` for each side of a polygon.
template <class Visit>
void for_each_side(const std::vector<Point>& corners, const Visit& visit) {
    for (std::size_t i = 0; i < corners.size(); ++i) visit(corners[i], corners[(i + 1) % corners.size()]);
}

/// Signed area of a polygon, positive if counter-clockwise.
double polygon_area(const std::vector<Point>& corners) {
    double sum = 0;
    for_each_side(corners, [&](Point p, Point q) { sum += signed_area(corners.front(), p, q); });
    return sum;
}

bool loop_contains(const Loop& loop, Point p) {
    if (loop.circle) return squared_length(p - loop.circle->centre) < loop.circle->radius * loop.circle->radius;
    bool inside = false;
    for_each_side(loop.corners, [&](Point a, Point b) {
        if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
    });
    return inside;
}

/// Shares of the edge from a to b, between 0 and 1, where a curve meets it.
void add_meetings(const Curve& curve, Point a, Point b, std::vector<double>& shares) {
    const Point d = b - a;
    const auto add = [&](double share) {
        if (share > 0 && share < 1) shares.push_back(share);
    };
    if (curve.is_circle()) {
        const Point from = a - curve.circle.centre;
        const double half = dot(from, d) / squared_length(d);
        const double rest = half * half - (squared_length(from) - curve.circle.radius * curve.circle.radius) / squared_length(d);
        if (rest <= 0) return;
        add(-half - std::sqrt(rest));
        add(-half + std::sqrt(rest));
        return;
    }
    const Point side = curve.to - curve.from;
    const double sine = cross(d, side);
    if (std::abs(sine) <= round_off * length(d) * length(side)) return;
    const double along_side = cross(curve.from - a, d) / sine;
    if (along_side >= -round_off && along_side <= 1 + round_off) add(cross(curve.from - a, side) / sine);
}

/// Whether two curves of loops that are not neighbours in a polygon have a point in common.
bool meet(const Curve& a, const Curve& b) {
    if (a.is_circle() && b.is_circle()) {
        const double apart = length(a.circle.centre - b.circle.centre);
        return apart <= a.circle.radius + b.circle.radius && apart >= std::abs(a.circle.radius - b.circle.radius);
    }
    if (a.is_circle()) return meet(b, a);
    if (b.distance(a.from) == 0 || b.distance(a.to) == 0) return true;
    std::vector<double> shares;
    add_meetings(b, a.from, a.to, shares);
    return !shares.empty();
}

}  // namespace

Region rectangle(double width, double height) {
    const double x = width / 2;
    const double y = height / 2;
    return {"rectangle", {{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, {0, 1, 2, 3}}}, {}};
}

Region disc(double diameter, Pole pole, int diameters) {
    return {"disc", {{{}, {static_cast<std::uint8_t>(BoundaryPart::rim)}, Circle{{}, diameter / 2, pole, diameters}}}, {}};
}

void check(const Region& region) {
    const auto refuse = [&](const char* what) { throw UsageError("region " + region.name + ": " + what); };
    if (region.loops.empty()) refuse("has no loop around it");
    for (const Loop& loop : region.loops) {
        const bool outer = &loop == &region.loops.front();
        if (loop.circle ? !(loop.circle->radius > 0) : loop.corners.size() < 3) {
            refuse("a loop needs three corners or a radius above 0");
        }
        if (loop.parts.size() != (loop.circle ? 1 : loop.corners.size())) refuse("each side of a loop needs one part");
        for (const std::uint8_t part : loop.parts) {
            if (part >= region.part_names.size()) refuse("a side has a part without a name");
        }
        if (!loop.circle && (polygon_area(loop.corners) > 0) != outer) {
            refuse("corners must be counter-clockwise around the region and clockwise around holes");
        }
        const Point some = loop.circle ? loop.circle->centre + Point{loop.circle->radius, 0} : loop.corners.front();
        for (const Loop& other : region.loops) {
            if (&other == &loop) continue;
            if (loop_contains(other, some) != (!outer && &other == &region.loops.front())) {
                refuse("a hole is not inside, or inside another");
            }
        }
    }
    const auto curves = curves_of({region.name, region.loops, {}});
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (!curves[i].is_circle() && curves[i].from == curves[i].to) refuse("two corners are the same");
        for (std::size_t j = i + 1; j < curves.size(); ++j) {
            const Curve& a = curves[i];
            const Curve& b = curves[j];
            if (!a.is_circle() && !b.is_circle() && (a.to == b.from || b.to == a.from)) {
                // Neighbours share a corner; they must not lie upon each other.
                const Point shared = a.to == b.from ? a.to : a.from;
                const Point p = (a.to == b.from ? a.from : a.to) - shared;
                const Point q = (a.to == b.from ? b.to : b.from) - shared;
                if (cross(p, q) == 0 && dot(p, q) > 0) refuse("a side lies on the next");
            } else if (meet(a, b)) {
                refuse("sides of loops cross or touch each other");
            }
        }
    }
    for (const PrescribedEdge& e : region.edges) {
        if (!(squared_length(e.to - e.from) > 0)) refuse("a prescribed edge needs a length above 0");
    }
}

Box bounds(const Region& region) {
    const Loop& loop = region.loops.front();
    if (loop.circle) {
        const Point reach{loop.circle->radius, loop.circle->radius};
        return {loop.circle->centre - reach, loop.circle->centre + reach};
    }
    Box box{loop.corners.front(), loop.corners.front()};
    for (const Point p : loop.corners) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

double area(const Region& region) {
    double sum = 0;
    for (const Loop& loop : region.loops) {
        const double own = loop.circle ? pi * loop.circle->radius * loop.circle->radius : std::abs(polygon_area(loop.corners));
        sum += &loop == &region.loops.front() ? own : -own;
    }
    return sum;
}

double perimeter(const Region& region) {
    double sum = 0;
    for (const Loop& loop : region.loops) {
        if (loop.circle) sum += 2 * pi * loop.circle->radius;
        for_each_side(loop.corners, [&](Point p, Point q) { sum += length(q - p); });
    }
    return sum;
}

bool contains(const Region& region, Point p) {
    bool inside = false;
    for (const Loop& loop : region.loops) inside = inside != loop_contains(loop, p);
    return inside;
}

double depth_inside(const Region& region, Point p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Curve& curve : curves_of({region.name, region.loops, {}})) nearest = std::min(nearest, curve.distance(p));
    return contains(region, p) ? nearest : -nearest;
}

bool is_round(const Region& region) { return region.loops.size() == 1 && region.loops.front().circle.has_value(); }

bool is_plain(const Region& region) {
    return region.loops.size() == 1 && region.edges.empty() && (is_round(region) || is_convex(region.loops.front().corners));
}

std::vector<PrescribedEdge> clip(const Region& region, const PrescribedEdge& edge) {
    std::vector<double> shares{0, 1};
    for (const Curve& curve : curves_of({region.name, region.loops, {}})) add_meetings(curve, edge.from, edge.to, shares);
    std::sort(shares.begin(), shares.end());
    const auto at = [&](double share) {
        if (share == 0 || share == 1) return share == 0 ? edge.from : edge.to;
        return edge.from + share * (edge.to - edge.from);
    };
    const Box box = bounds(region);
    const double least = round_off * (box.width() + box.height());
    std::vector<PrescribedEdge> pieces;
    for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
        const PrescribedEdge piece{at(shares[i]), at(shares[i + 1]), edge.kind};
        // A piece along a side is no piece inside.
        if (length(piece.to - piece.from) > least && depth_inside(region, midpoint(piece.from, piece.to)) > least) {
            pieces.push_back(piece);
        }
    }
    return pieces;
}

bool can_be_cut_off(Point before, Point at, Point after) {
    const Point u = unit(after - at);
    const Point v = unit(before - at);
    const double cosine = dot(u, v);
    return cross(u, v) > 0 && cosine < sharpest_shared && cosine > bluntest_shared;
}

double Curve::distance(Point p) const {
    if (is_circle()) return std::abs(circle.radius - length(p - circle.centre));
    if (dot(p - from, along) < 0) return length(p - from);
    if (dot(p - to, along) > 0) return length(p - to);
    return std::abs(dot(left_of(along), p) - dot(left_of(along), from));
}

Point Curve::moved_off(Point p, bool inside, double depth) const {
    if (is_circle()) {
        const Point radial = p - circle.centre;
        const double aim = circle.radius + (kind == Kind::circle ? -depth : depth);
        return squared_length(radial) > 0 ? circle.centre + (aim / length(radial)) * radial : p;
    }
    const Point normal = left_of(along);
    const bool before = dot(p - from, along) < 0;
    if (before || dot(p - to, along) > 0) {
        const Point end = before ? from : to;
        return end + (inside ? depth : -depth) * unit(p - end);
    }
    const double height = dot(normal, p);
    const double offset = dot(normal, from);
    // The part of the point along the normal is exchanged as a whole, so that sides along x or y give exact coordinates.
    return (p - height * normal) + (offset + (kind == Kind::prescribed && height < offset ? -depth : depth)) * normal;
}

std::vector<Curve> curves_of(const Region& region) {
    std::vector<Curve> curves;
    for (const Loop& loop : region.loops) {
        const bool outer = &loop == &region.loops.front();
        if (loop.circle) curves.push_back({outer ? Curve::Kind::circle : Curve::Kind::circular_hole, {}, {}, {}, *loop.circle});
        for_each_side(loop.corners, [&](Point p, Point q) { curves.push_back({Curve::Kind::side, p, q, unit(q - p), {}}); });
    }
    for (const PrescribedEdge& e : region.edges) {
        curves.push_back({Curve::Kind::prescribed, e.from, e.to, unit(e.to - e.from), {}});
    }
    return curves;
}

}  // namespace graincrack::mesher
