#include "mesher/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace graincrack::mesher {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int n_sides = 4;

/// Shares 0 = s₀ < s₁ < … < s_n = 1 of a line cut into n pieces of random length.
std::vector<double> cut_line(int n, double spread, RandomNumbers& random) {
    // Uniform within ±√3 spread, which has the requested standard deviation and no outliers.
    const double half_range = std::min(std::numbers::sqrt3 * spread, 0.6);
    std::vector<double> shares(static_cast<std::size_t>(n) + 1, 0.0);
    for (std::size_t i = 1; i < shares.size(); ++i) shares[i] = shares[i - 1] + 1 + half_range * random.symmetric();
    for (double& s : shares) s /= shares.back();
    return shares;
}

/// Numbers of edges on bottom, right, top and left that add up to n, in proportion to the lengths; opposite sides have
/// the same number; if n is odd, one of the long sides has one edge more.
std::array<int, n_sides> edges_per_side(const Shape& shape, int n) {
    const bool upright = shape.height >= shape.width;
    const double long_length = upright ? shape.height : shape.width;
    const double short_length = upright ? shape.width : shape.height;
    int on_long = 1;
    int on_short = 1;
    while (2 * (on_long + on_short) + 1 < n) {
        if (long_length / on_long > short_length / on_short * (1 - 1e-12)) {
            ++on_long;
        } else {
            ++on_short;
        }
    }
    const int one_more = n % 2;
    if (upright) return {on_short, on_long + one_more, on_short, on_long};
    return {on_long + one_more, on_short, on_long, on_short};
}

Outline rectangle_outline(const Shape& shape, int n, double spread, RandomNumbers& random) {
    const double x = shape.width / 2;
    const double y = shape.height / 2;
    const std::array<Point, n_sides> corners{Point{-x, -y}, Point{x, -y}, Point{x, y}, Point{-x, y}};
    const auto edges = edges_per_side(shape, n);
    Outline outline;
    for (std::size_t side = 0; side < n_sides; ++side) {
        const Point from = corners[side];
        const Point to = corners[(side + 1) % n_sides];
        const auto shares = cut_line(edges[side], spread, random);
        outline.corners.push_back(static_cast<int>(outline.points.size()));
        for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
            // The coordinate that is constant along the side is copied exactly, so that the side is straight.
            Point p = from;
            if (from.x != to.x) p.x += shares[i] * (to.x - from.x);
            if (from.y != to.y) p.y += shares[i] * (to.y - from.y);
            outline.points.push_back(p);
            outline.parts.push_back(static_cast<BoundaryPart>(side));
        }
    }
    return outline;
}

/// Polar angles of the rim points, counter-clockwise from just left of the upper pole's facet (or from the pole).
std::vector<double> rim_angles(const Shape& shape, int n, double spread, RandomNumbers& random) {
    const bool facets = shape.pole == Pole::facet;
    const int arcs = 2 * shape.diameters;  // from pole to pole
    const double half_facet = facets ? pi / n : 0.0;
    const double span = pi / shape.diameters - 2 * half_facet;
    const int between = facets ? n - arcs : n;  // edges beside the pole facets
    const auto edges_before = [&](int arc) { return (arc * between + arcs - 1) / arcs; };
    std::vector<double> angles;
    for (int arc = 0; arc < arcs; ++arc) {
        const double start = (0.5 + static_cast<double>(arc) / shape.diameters) * pi + half_facet;
        const auto shares = cut_line(edges_before(arc + 1) - edges_before(arc), spread, random);
        const std::size_t n_points = shares.size() - (facets ? 0 : 1);  // the next pole vertex opens the next arc
        for (std::size_t i = 0; i < n_points; ++i) angles.push_back(start + shares[i] * span);
    }
    return angles;
}

double polygon_area(const std::vector<Point>& points) {
    double doubled = 0;
    for (std::size_t i = 0; i < points.size(); ++i) doubled += cross(points[i], points[(i + 1) % points.size()]);
    return doubled / 2;
}

/// Rim points at a radius. Points at a pole are moved along its diameter until the diameter has its length. `pole_of`: number of
/// the pole, counter-clockwise from the upper one, or −1.
std::vector<Point> rim_points(const Shape& shape, const std::vector<double>& angles, const std::vector<int>& pole_of,
                              double radius) {
    const double height = shape.width / 2;
    std::vector<Point> points(angles.size());
    for (std::size_t i = 0; i < angles.size(); ++i) {
        points[i] = {radius * std::cos(angles[i]), radius * std::sin(angles[i])};
        if (pole_of[i] < 0) continue;
        if (pole_of[i] % shape.diameters == 0) {
            points[i].y = std::copysign(height, points[i].y);
        } else {
            const double angle = (0.5 + static_cast<double>(pole_of[i]) / shape.diameters) * pi;
            const Point along{std::cos(angle), std::sin(angle)};
            points[i] = points[i] + (height - dot(points[i], along)) * along;
        }
    }
    return points;
}

Outline disc_outline(const Shape& shape, int n, double spread, RandomNumbers& random) {
    const double radius = shape.width / 2;
    const auto angles = rim_angles(shape, n, spread, random);
    const double reach = shape.pole == Pole::facet ? pi / n : 0.0;
    std::vector<int> pole_of(angles.size(), -1);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double from_upper = (angles[i] - pi / 2) / (pi / shape.diameters);  // in units of the angle between poles
        const double pole = std::round(from_upper);
        if (std::abs(from_upper - pole) * (pi / shape.diameters) < reach + 1e-9) {
            pole_of[i] = static_cast<int>(pole) % (2 * shape.diameters);
        }
    }
    Outline outline;
    double rim_radius = radius;
    // The area grows almost as the square of the rim radius (not exactly, because of the moved nodes at the poles): a few
    // corrections suffice.
    for (int i = 0; i < 100; ++i) {
        outline.points = rim_points(shape, angles, pole_of, rim_radius);
        const double ratio = shape.area() / polygon_area(outline.points);
        if (std::abs(ratio - 1) < 4e-16) break;
        rim_radius *= std::sqrt(ratio);
    }
    if (shape.pole == Pole::vertex) {
        for (std::size_t i = 0; i < angles.size(); ++i) {
            if (pole_of[i] >= 0 && pole_of[i] % shape.diameters == 0) outline.points[i].x = 0;
        }
    }
    outline.parts.assign(outline.points.size(), BoundaryPart::rim);
    if (shape.pole == Pole::facet) {
        const double half_length = std::abs(outline.points.front().x);
        outline.loading_arc = 2 * std::atan2(half_length, radius);
    }
    return outline;
}

}  // namespace

double Shape::area() const { return kind == ShapeKind::disc ? pi / 4 * width * width : width * height; }

double Shape::perimeter() const { return kind == ShapeKind::disc ? pi * width : 2 * (width + height); }

std::string Shape::name() const { return kind == ShapeKind::disc ? "disc" : "rectangle"; }

int admissible_boundary_count(const Shape& shape, double wanted, bool odd) {
    (void)shape;  // both shapes need four points and allow any larger number
    const int parity = odd ? 1 : 0;
    const int n = 2 * static_cast<int>(std::lround((wanted - parity) / 2)) + parity;
    return std::max(n, 4 + parity);
}

Outline make_outline(const Shape& shape, int n, double spread, RandomNumbers& random) {
    return shape.kind == ShapeKind::disc ? disc_outline(shape, n, spread, random) : rectangle_outline(shape, n, spread, random);
}

void turn_to_load(const Shape& shape, std::vector<Point>& points) {
    if (shape.loaded_diameter == 0) return;
    const double angle = -pi * shape.loaded_diameter / shape.diameters;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double radius = shape.width / 2;
    for (Point& p : points) {
        p = {c * p.x - s * p.y, s * p.x + c * p.y};
        if (std::abs(std::abs(p.y) - radius) < 1e-12 * radius) p.y = std::copysign(radius, p.y);
    }
}

double depth_inside(const Shape& shape, Point p) {
    if (shape.kind == ShapeKind::disc) return shape.width / 2 - length(p);
    return std::min(shape.width / 2 - std::abs(p.x), shape.height / 2 - std::abs(p.y));
}

}  // namespace graincrack::mesher
