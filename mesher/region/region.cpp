#include "mesher/region/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/plane/triangulation.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

/// Adds points of an arc from `from` over an angle, without its end.
void add_arc(std::vector<Point>& points, Point centre, Point from, double angle, double side) {
    constexpr int fewest = 8;
    const Point start = from - centre;
    const int n = std::max(fewest, static_cast<int>(std::abs(angle) * length(start) / side));
    for (int i = 0; i < n; ++i) {
        const double turn = angle * i / n;
        points.push_back(centre + std::cos(turn) * start + std::sin(turn) * left_of(start));
    }
}

}  // namespace

Region stretched(const Region& region, const Stretch& stretch, double side) {
    Region image = region;
    if (stretch.is_identity()) return image;
    for (Loop& loop : image.loops) {
        std::vector<Point> corners;
        if (loop.circle) {
            const bool outer = &loop == &image.loops.front();
            const Circle& circle = *loop.circle;
            add_arc(corners, circle.centre, circle.centre + Point{circle.radius, 0}, (outer ? 2 : -2) * std::numbers::pi, side);
        }
        for (std::size_t i = 0; i < loop.corners.size(); ++i) {
            const Point from = loop.corners[i];
            const auto centre = loop.centre(i);
            if (!centre) {
                corners.push_back(from);
                continue;
            }
            const Curve arc{Curve::Kind::arc, from, loop.corners[(i + 1) % loop.corners.size()], {}, Circle{*centre, 0}};
            add_arc(corners, *centre, from, arc.arc_angle(), side);
        }
        for (Point& p : corners) p = stretch.equiaxed(p);
        const std::size_t n = corners.size();
        loop = {std::move(corners), std::vector<std::uint8_t>(n, loop.parts.front())};
    }
    for (PrescribedEdge& e : image.edges) {
        e.from = stretch.equiaxed(e.from);
        e.to = stretch.equiaxed(e.to);
    }
    return image;
}

namespace {

constexpr double pi = std::numbers::pi;
// Corners between these angles are shared by two grains; a sharper one belongs to one, blunter ones are shared anyway. By trial.
const double sharpest_shared = std::cos(75 * pi / 180);
const double bluntest_shared = std::cos(150 * pi / 180);
constexpr double round_off = 1e-12;  ///< over the extent of a region

/// Calls `visit(from, to)` for each side of a polygon.
template <class Visit>
void for_each_side(const std::vector<Point>& corners, const Visit& visit) {
    for (std::size_t i = 0; i < corners.size(); ++i) visit(corners[i], corners[(i + 1) % corners.size()]);
}

/// True if a point lies in the sector of an arc, which is less than 180° wide.
bool is_beside_arc(const Curve& arc, Point p) {
    const Point centre = arc.circle.centre;
    return cross(arc.from - centre, p - centre) >= 0 && cross(p - centre, arc.to - centre) >= 0;
}

/// Calls `visit(curve)` for the sides of a polygon that are arcs.
template <class Visit>
void for_each_arc(const Loop& loop, const Visit& visit) {
    for (std::size_t i = 0; i < loop.centres.size(); ++i) {
        if (!loop.centres[i]) continue;
        const Point from = loop.corners[i];
        const Circle circle{*loop.centres[i], length(from - *loop.centres[i])};
        visit(Curve{Curve::Kind::arc, from, loop.corners[(i + 1) % loop.corners.size()], {}, circle});
    }
}

bool loop_contains(const Loop& loop, Point p) {
    if (loop.circle) return squared_length(p - loop.circle->centre) < loop.circle->radius * loop.circle->radius;
    bool inside = false;
    for_each_arc(loop, [&](const Curve& arc) {
        const bool beyond_chord = cross(arc.to - arc.from, p - arc.from) <= 0;
        if (beyond_chord && squared_length(p - arc.circle.centre) < arc.circle.radius * arc.circle.radius) inside = true;
    });
    if (inside) return true;
    for_each_side(loop.corners, [&](Point a, Point b) {
        if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
    });
    return inside;
}

/// Fractions of the edge from a to b at which a curve meets it.
void add_meetings(const Curve& curve, Point a, Point b, std::vector<double>& shares) {
    const Point d = b - a;
    const bool is_arc = curve.kind == Curve::Kind::arc;
    const auto add = [&](double share) {
        if (share > 0 && share < 1 && (!is_arc || is_beside_arc(curve, a + share * d))) shares.push_back(share);
    };
    if (curve.is_circle() || is_arc) {
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

}  // namespace

Box bounds(const Region& region) {
    const Loop& loop = region.loops.front();
    if (loop.circle) {
        const Point reach{loop.circle->radius, loop.circle->radius};
        return {loop.circle->centre - reach, loop.circle->centre + reach};
    }
    Box box = box_of(loop.corners);
    for_each_arc(loop, [&](const Curve& arc) {
        for (const Point axis : {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}}) {
            const Point extreme = arc.circle.centre + arc.circle.radius * axis;
            if (is_beside_arc(arc, extreme)) box.add(extreme);
        }
    });
    return box;
}

double area(const Region& region) {
    double sum = 0;
    for (const Loop& loop : region.loops) {
        const double own = loop.circle ? pi * loop.circle->radius * loop.circle->radius : std::abs(area_of(loop.corners));
        sum += &loop == &region.loops.front() ? own : -own;
        for_each_arc(loop, [&](const Curve& arc) {
            sum += arc.circle.radius * arc.circle.radius / 2 * (arc.arc_angle() - std::sin(arc.arc_angle()));
        });
    }
    return sum;
}

double perimeter(const Region& region) {
    double sum = 0;
    for (const Curve& curve : curves_of({region.name, region.loops, {}})) sum += curve.length();
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

std::optional<FlawKind> flaw_kind(std::string_view contact_class, std::string_view state) {
    const bool is_state = contact_class == "broken" || contact_class == "intact";
    if (!contact_class.empty() && !is_state && !is_flaw_name(contact_class)) return std::nullopt;
    if (is_state && !state.empty()) return std::nullopt;
    const std::string_view start = is_state                ? contact_class
                                   : !state.empty()        ? state
                                   : contact_class.empty() ? "broken"
                                                           : "intact";
    if (start != "broken" && start != "intact") return std::nullopt;
    return FlawKind{start == "broken" ? ContactKind::pre_existing_crack : ContactKind::grain_boundary,
                    is_state ? "" : std::string(contact_class)};
}

bool is_round(const Region& region) { return !region.loops.empty() && region.loops.front().circle.has_value(); }

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
        const PrescribedEdge piece{at(shares[i]), at(shares[i + 1]), edge.kind, edge.name, edge.needed};
        // Pieces along a side are not inside.
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

Point Loop::ahead(std::size_t side) const {
    const Point from = corners[side];
    return centre(side) ? from + left_of(from - *centre(side)) : corners[(side + 1) % corners.size()];
}

Point Loop::behind(std::size_t side) const {
    const Point to = corners[(side + 1) % corners.size()];
    return centre(side) ? to - left_of(to - *centre(side)) : corners[side];
}

double Curve::arc_angle() const {
    const Point p = from - circle.centre;
    const Point q = to - circle.centre;
    return std::atan2(cross(p, q), dot(p, q));
}

double Curve::length() const {
    if (is_circle()) return 2 * pi * circle.radius;
    return kind == Kind::arc ? circle.radius * arc_angle() : mesher::length(to - from);
}

double Curve::distance(Point p) const {
    using mesher::length;
    if (is_circle()) return std::abs(circle.radius - length(p - circle.centre));
    if (kind == Kind::arc) {
        return is_beside_arc(*this, p) ? std::abs(circle.radius - length(p - circle.centre))
                                       : std::min(length(p - from), length(p - to));
    }
    if (dot(p - from, along) < 0) return length(p - from);
    if (dot(p - to, along) > 0) return length(p - to);
    return std::abs(dot(left_of(along), p) - dot(left_of(along), from));
}

Point Curve::moved_off(Point p, bool inside, double depth) const {
    using mesher::length;
    const bool is_arc = kind == Kind::arc;
    if (is_circle() || (is_arc && is_beside_arc(*this, p))) {
        const Point radial = p - circle.centre;
        const double aim = circle.radius + (kind == Kind::circular_hole ? depth : -depth);
        return squared_length(radial) > 0 ? circle.centre + (aim / length(radial)) * radial : p;
    }
    const Point normal = left_of(along);
    const bool before = is_arc ? length(p - from) < length(p - to) : dot(p - from, along) < 0;
    if (before || is_arc || dot(p - to, along) > 0) {
        const Point end = before ? from : to;
        return end + (inside ? depth : -depth) * unit(p - end);
    }
    const double height = dot(normal, p);
    const double offset = dot(normal, from);
    // The normal part of the point is replaced as a whole, so that sides along x or y have exact coordinates.
    return (p - height * normal) + (offset + (kind == Kind::prescribed && height < offset ? -depth : depth)) * normal;
}

std::vector<Curve> curves_of(const Region& region) {
    std::vector<Curve> curves;
    for (const Loop& loop : region.loops) {
        const bool outer = &loop == &region.loops.front();
        if (loop.circle) curves.push_back({outer ? Curve::Kind::circle : Curve::Kind::circular_hole, {}, {}, {}, *loop.circle});
        std::size_t side = 0;
        for_each_side(loop.corners, [&](Point p, Point q) {
            const auto centre = loop.centre(side++);
            if (centre) {
                curves.push_back({Curve::Kind::arc, p, q, {}, Circle{*centre, length(p - *centre)}});
            } else {
                curves.push_back({Curve::Kind::side, p, q, unit(q - p), {}});
            }
        });
    }
    for (const PrescribedEdge& e : region.edges) {
        curves.push_back({Curve::Kind::prescribed, e.from, e.to, unit(e.to - e.from), {}});
    }
    return curves;
}

}  // namespace graincrack::mesher
