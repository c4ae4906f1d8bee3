#include "mesher/region/grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "share/base/error.hpp"
#include "share/base/quantities.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

using Kind = Grading::Kind;

struct Direction {
    std::string_view key;
    std::string_view value;
    Kind kind;
};
constexpr std::array<Direction, 5> directions{{{"along", "x", Kind::along_x},
                                               {"along", "y", Kind::along_y},
                                               {"towards", "flaws", Kind::towards_flaws},
                                               {"towards", "boundary", Kind::towards_boundary},
                                               {"towards", "holes", Kind::towards_holes}}};

constexpr const char* examples =
    "along=x|y,from=0.5,to=2 (relative edges at the lower and the upper end) or towards=flaws|boundary|holes,from=0.4,"
    "distance=10mm (relative edge there, growing to 1 at the distance)";

}  // namespace

std::string name_of(Grading::Kind kind) {
    const auto* const row =
        std::find_if(directions.begin(), directions.end(), [&](const Direction& d) { return d.kind == kind; });
    return fmt::format("{} {}", row->key, row->value);
}

Grading parse_grading(std::string_view text, const std::string& name) {
    Grading grading;
    std::optional<Kind> kind;
    std::optional<double> from;
    std::optional<double> to;
    std::optional<double> distance;
    for (const std::string_view item : split(text, ',')) {
        const auto [key, value] = sides_of_equals(item);
        const std::string where = name + ": " + key;
        const auto* direction = std::find_if(directions.begin(), directions.end(),
                                             [&, k = key, v = value](const Direction& d) { return d.key == k && d.value == v; });
        if (direction != directions.end() && !kind) {
            kind = direction->kind;
        } else if (key == "from") {
            from = parse_quantity(value, quantity::relative_edge, where);
        } else if (key == "to") {
            to = parse_quantity(value, quantity::relative_edge, where);
        } else if (key == "distance") {
            distance = parse_quantity(value, quantity::grading_distance, where);
        } else {
            throw UsageError(fmt::format("{}: \"{}\" is not understood; give {}", name, item.substr(0, 60), examples));
        }
    }
    if (kind) grading.kind = *kind;
    const bool along = grading.is_along();
    if (!kind || !from || to.has_value() != along || distance.has_value() == along) {
        throw UsageError(fmt::format("{}: something is missing or too much; give {}", name, examples));
    }
    grading.from = *from;
    grading.to = to.value_or(1);
    grading.distance = distance.value_or(0);
    return grading;
}

GradedSize::GradedSize(const Grading& grading, const Region& region) : grading_(grading), box_(bounds(region)) {
    if (grading.is_along()) return;
    if (grading.kind == Kind::towards_flaws) {
        curves_ = curves_of({region.name, {}, region.edges});
    } else if (grading.kind == Kind::towards_boundary) {
        curves_ = curves_of({region.name, {region.loops.front()}, {}});
    } else {
        for (const Curve& curve : curves_of({region.name, region.loops, {}})) {
            if (curve.kind == Curve::Kind::circular_hole) curves_.push_back(curve);
        }
    }
    if (curves_.empty()) {
        throw UsageError(
            grading.kind == Kind::towards_flaws
                ? "--grade: there is no flaw towards which sizes could be graded; add a slit, a notch with an angle, "
                  "--flaws or --joint-set"
                : "--grade: there is no hole towards which sizes could be graded; add --hole");
    }
}

double GradedSize::fraction(Point p) const {
    if (grading_.kind == Kind::along_x) return std::clamp((p.x - box_.low.x) / box_.width(), 0.0, 1.0);
    if (grading_.kind == Kind::along_y) return std::clamp((p.y - box_.low.y) / box_.height(), 0.0, 1.0);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Curve& curve : curves_) nearest = std::min(nearest, curve.distance(p));
    return std::min(1.0, nearest / grading_.distance);
}

double GradedSize::slope() const {
    const double distance = grading_.kind == Kind::along_x   ? box_.width()
                            : grading_.kind == Kind::along_y ? box_.height()
                                                             : grading_.distance;
    return std::abs(grading_.to - grading_.from) / distance;
}

}  // namespace graincrack::mesher
