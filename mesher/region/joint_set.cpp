#include "mesher/region/joint_set.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "mesher/plane/random_numbers.hpp"
#include "share/base/error.hpp"
#include "share/base/quantities.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr double max_joints = 10'000;
constexpr double variation = 0.3;  ///< half range of lengths of joints and bridges over their mean

}  // namespace

JointSet parse_joint_set(std::string_view text, const std::string& name) {
    JointSet set;
    set.name = name;
    std::optional<double> spacing;
    std::optional<double> dip;
    std::optional<double> length;
    std::string contact_class, state;
    for (const std::string_view item : split(text, ',')) {
        const auto [key, value] = sides_of_equals(item);
        const std::string where = name + ": " + key;
        if (key == "spacing") {
            spacing = parse_quantity(value, quantity::joint_length, where);
        } else if (key == "dip") {
            dip = parse_quantity(value, quantity::direction, where);
        } else if (key == "persistence") {
            set.persistence = parse_quantity(value, quantity::persistence, where);
        } else if (key == "length") {
            length = parse_quantity(value, quantity::joint_length, where);
        } else if (key == "class") {
            contact_class = value;
        } else if (key == "state") {
            state = value;
        } else {
            throw UsageError(
                fmt::format("{}: \"{}\" is not understood; give spacing=20mm,dip=45deg and, if needed, persistence=0.7, "
                            "length=30mm, class=broken|intact|NAME, state=broken|intact",
                            name, item.substr(0, 60)));
        }
    }
    if (!spacing || !dip) throw UsageError(name + ": spacing and dip are needed; give spacing=20mm,dip=45deg");
    const auto kind = flaw_kind(contact_class, state);
    if (!kind) {
        throw UsageError(fmt::format("{}: class \"{}\" in state \"{}\" is not understood; {}", name, printable(contact_class),
                                     printable(state), kinds_of_flaws));
    }
    set.kind = *kind;
    set.spacing = *spacing;
    set.dip = *dip;
    set.length = length.value_or(set.spacing);
    return set;
}

std::vector<PrescribedEdge> joints_of(const JointSet& set, const Region& region, double edge, std::uint64_t seed,
                                      std::size_t number) {
    const double bridge = set.length * (1 - set.persistence) / set.persistence;
    const bool through = set.persistence == 1;
    const auto require = [&](double value, double least, const char* what) {
        if (value < least) {
            throw UsageError(fmt::format("{}: {} of {} is less than {} with grain edges of {}; give more, or smaller grains",
                                         set.name, what, format_length(value), format_length(least), format_length(edge)));
        }
    };
    require(set.spacing, 2 * edge, "a spacing");
    if (!through) require(set.length, 2 * edge, "a length");
    if (!through) require(bridge, 2 * edge, "bridges between joints (length x (1 - persistence)/persistence)");
    const Box box = bounds(region);
    const Point centre = midpoint(box.low, box.high);
    const double reach = 0.5 * length(box.high - box.low);
    const double n_lines = 2 * reach / set.spacing;
    if (n_lines * (through ? 1 : 2 * reach / (set.length + bridge) + 1) > max_joints) {
        throw UsageError(fmt::format("{}: more than {} joints; give a larger spacing or length", set.name, max_joints));
    }
    RandomNumbers random(seed, joint_stream + number);
    const Point along{std::cos(set.dip), std::sin(set.dip)};
    std::vector<PrescribedEdge> joints;
    const auto varied = [&](double mean) { return mean * (1 + variation * random.symmetric()); };
    for (double offset = -reach + set.spacing * random.uniform(); offset < reach; offset += set.spacing) {
        const Point origin = centre + offset * left_of(along);
        const auto add = [&](double from, double to) {
            joints.push_back({origin + from * along, origin + to * along, set.kind, set.name, false});
        };
        if (through) {
            add(-1.01 * reach, 1.01 * reach);
            continue;
        }
        for (double at = -reach - random.uniform() * (set.length + bridge); at < reach;) {
            const double end = at + varied(set.length);
            add(at, end);
            at = end + varied(bridge);
        }
    }
    return joints;
}

}  // namespace graincrack::mesher
