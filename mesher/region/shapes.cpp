#include "mesher/region/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr auto rim = static_cast<std::uint8_t>(BoundaryPart::rim);
constexpr auto top = static_cast<std::uint8_t>(BoundaryPart::top);
constexpr auto bottom = static_cast<std::uint8_t>(BoundaryPart::bottom);

}  // namespace

Region rectangle(double width, double height) {
    const double x = width / 2;
    const double y = height / 2;
    return {"rectangle", {{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, {0, 1, 2, 3}}}, {}};
}

Region disc(double diameter, Pole pole, int diameters, int loaded_diameter) {
    return {"disc", {{{}, {rim}, Circle{{}, diameter / 2, pole, diameters, loaded_diameter}}}, {}};
}

Region disc_with_flats(double diameter, double flats) {
    const double x = diameter / 2 * std::sin(flats / 2);
    const double y = diameter / 2 * std::cos(flats / 2);
    const Point centre;
    Region region{"disc", {{{{x, -y}, {x, y}, {-x, y}, {-x, -y}}, {rim, top, rim, bottom}, {}, {centre, {}, centre, {}}}}, {}};
    region.flats = flats;
    return region;
}

Region ring(double outer_diameter, double inner_diameter) {
    Region region = disc(outer_diameter);
    region.name = "ring";
    region.part_names[rim] = "outer";
    region.part_names.push_back("inner");
    region.loops.push_back({{}, {rim + 1}, Circle{{}, inner_diameter / 2}});
    return region;
}

Region half_disc(double diameter) {
    const double radius = diameter / 2;
    const Point centre{0, -radius / 2};
    const Point crown{0, radius / 2};
    return {"half-disc",
            {{{{-radius, centre.y}, {radius, centre.y}, crown}, {bottom, rim, rim}, {}, {std::nullopt, centre, centre}}},
            {}};
}

Region polygon(std::vector<Point> corners, const std::vector<std::string>& parts) {
    Region region;
    region.name = "polygon";
    std::vector<std::uint8_t> numbers;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::string name = i < parts.size() && !parts[i].empty() ? parts[i] : "side";
        auto found = std::find(region.part_names.begin(), region.part_names.end(), name);
        if (found == region.part_names.end()) {
            if (region.part_names.size() > std::numeric_limits<std::uint8_t>::max()) {
                throw InputError("polygon: more than 251 names of parts");
            }
            found = region.part_names.insert(found, name);
        }
        numbers.push_back(static_cast<std::uint8_t>(found - region.part_names.begin()));
    }
    if (area_of(corners) < 0) {  // side i runs from corner i to the next, also in reverse
        std::reverse(corners.begin(), corners.end());
        std::reverse(numbers.begin(), numbers.end());
        std::rotate(numbers.begin(), numbers.begin() + 1, numbers.end());
    }
    region.loops.push_back({std::move(corners), std::move(numbers)});
    return region;
}

void add_hole(Region& region, Point centre, double radius, const std::string& where) {
    for (const Curve& curve : curves_of({region.name, region.loops, {}})) {
        if (curve.distance(centre) <= radius) {
            throw UsageError(
                fmt::format("{}: a hole of radius {} at ({}, {}) meets the boundary or another hole; give one inside", where,
                            format_length(radius), format_length(centre.x), format_length(centre.y)));
        }
    }
    if (!contains(region, centre)) {
        throw UsageError(fmt::format("{}: ({}, {}) lies outside of the specimen or in another hole; give a point inside", where,
                                     format_length(centre.x), format_length(centre.y)));
    }
    if (region.part_names.size() > std::numeric_limits<std::uint8_t>::max()) {
        throw UsageError(where + ": too many parts of the boundary; a specimen has at most 256");
    }
    const auto n_before = std::count_if(region.part_names.begin(), region.part_names.end(),
                                        [](const std::string& name) { return name.rfind("hole_", 0) == 0; });
    region.loops.push_back({{}, {static_cast<std::uint8_t>(region.part_names.size())}, Circle{centre, radius}});
    region.part_names.push_back(fmt::format("hole_{}", n_before + 1));
}

PrescribedEdge central_slit(const Region& region, double length, double angle, const std::string& where) {
    const Box box = bounds(region);
    const Point along{std::cos(angle), std::sin(angle)};
    const Point reach = mesher::length(box.high - box.low) * along;
    const auto pieces = clip(region, {-1 * reach, reach, {}, where});
    const double room = pieces.empty() ? 0 : mesher::length(pieces.back().to - pieces.front().from);
    if (length > room * (1 + 1e-9)) {
        throw UsageError(where + ": " + format_length(length) + " has no room; give at most " + format_length(room) +
                         ", which is a joint through the specimen");
    }
    return {-length / 2 * along, length / 2 * along, ContactKind::pre_existing_crack, where};
}

PrescribedEdge slit_from_below(const Region& region, double length, const std::string& where, double at) {
    const Box box = bounds(region);
    if (!(box.low.x < at && at < box.high.x)) {
        throw UsageError(fmt::format("{}-at: {} lies outside of the specimen; give more than {} and less than {}", where,
                                     format_length(at), format_length(box.low.x), format_length(box.high.x)));
    }
    if (!(length < box.height())) {
        throw UsageError(where + ": " + format_length(length) + " has no room; give less than " + format_length(box.height()));
    }
    return {{at, box.low.y}, {at, box.low.y + length}, ContactKind::pre_existing_crack, where};
}

Point centre_region(Region& region) {
    const Box box = bounds(region);
    const Point move = -1 * midpoint(box.low, box.high);
    const auto shift = [&](Point& p) { p = p + move; };
    for (Loop& loop : region.loops) {
        for (Point& p : loop.corners) shift(p);
        if (loop.circle) shift(loop.circle->centre);
        for (auto& centre : loop.centres) {
            if (centre) shift(*centre);
        }
    }
    for (PrescribedEdge& edge : region.edges) {
        shift(edge.from);
        shift(edge.to);
    }
    return move;
}

double turn_to_load(const Region& region) {
    if (!is_round(region)) return 0;
    const Circle& circle = *region.loops.front().circle;
    return -std::numbers::pi * circle.loaded_diameter / circle.diameters;
}

void turn_to_load(const Region& region, std::vector<Point>& points) {
    const double angle = turn_to_load(region);
    if (angle == 0) return;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double radius = region.loops.front().circle->radius;
    for (Point& p : points) {
        p = {c * p.x - s * p.y, s * p.x + c * p.y};
        if (std::abs(std::abs(p.y) - radius) < 1e-12 * radius) p.y = std::copysign(radius, p.y);
    }
}

}  // namespace graincrack::mesher
