#include "share/file/specimen_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "share/base/units.hpp"

namespace graincrack {

double width_of_part(const Specimen& specimen, BoundaryPart part) {
    double left = specimen.width, right = -specimen.width;
    for (std::size_t e = 0; e < specimen.n_boundary_edges(); ++e) {
        if (specimen.boundary_part[e] != static_cast<std::uint8_t>(part)) continue;
        for (const std::int32_t node : specimen.boundary_edges[e]) {
            left = std::min(left, specimen.node_position[static_cast<std::size_t>(node)][0]);
            right = std::max(right, specimen.node_position[static_cast<std::size_t>(node)][0]);
        }
    }
    return std::max(0.0, right - left);
}

std::optional<std::array<double, 2>> notch_ends(const Specimen& specimen) {
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (specimen.contact_kind[c] != static_cast<std::uint8_t>(ContactKind::pre_existing_crack)) continue;
        for (const std::int32_t node : specimen.contact_nodes[c]) {
            const double x = specimen.node_position[static_cast<std::size_t>(node)][0];
            left = std::min(left, x);
            right = std::max(right, x);
        }
    }
    if (!(left < right)) return std::nullopt;
    return std::array{left, right};
}

std::optional<EdgeNotch> edge_notch(const Specimen& specimen) {
    using Position = std::array<double, 2>;
    constexpr double same_position = 1e-9;  // over the size, as for contacts
    const double slack = same_position * (specimen.width + specimen.height);
    const auto meet = [slack](const Position& p, const Position& q) { return std::hypot(p[0] - q[0], p[1] - q[1]) <= slack; };
    std::vector<std::array<Position, 2>> rest;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (specimen.contact_kind[c] != static_cast<std::uint8_t>(ContactKind::pre_existing_crack)) continue;
        const auto& nodes = specimen.contact_nodes[c];
        rest.push_back({specimen.node_position[static_cast<std::size_t>(nodes[0])],
                        specimen.node_position[static_cast<std::size_t>(nodes[1])]});
    }
    std::vector<Position> reached;
    for (const auto& ends : rest) {
        for (const Position& end : ends) {
            if (reached.empty() && end[1] <= -specimen.height / 2 + slack) reached.push_back(end);
        }
    }
    if (reached.empty()) return std::nullopt;
    EdgeNotch notch{reached.front(), reached.front()};
    for (std::size_t i = 0; i < reached.size(); ++i) {
        if (reached[i][1] > notch.tip[1]) notch.tip = reached[i];
        std::erase_if(rest, [&](const std::array<Position, 2>& ends) {
            const Position at = reached[i];
            if (!meet(ends[0], at) && !meet(ends[1], at)) return false;
            reached.push_back(meet(ends[0], at) ? ends[1] : ends[0]);
            return true;
        });
    }
    return notch;
}

std::string open_boundaries_text(const Specimen& specimen) {
    const std::vector<std::int32_t> grain = grain_of_nodes(specimen);
    const auto crystal = [&](std::int32_t node) {
        const std::int32_t own = grain[static_cast<std::size_t>(node)];
        return specimen.grain_crystal.empty() ? own : specimen.grain_crystal[static_cast<std::size_t>(own)];
    };
    std::array<std::set<std::pair<std::int32_t, std::int32_t>>, 2> boundaries;  // closed, open
    std::array<double, 2> length{};
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const std::uint8_t kind = specimen.contact_kind[c];
        const bool is_open = kind == static_cast<std::uint8_t>(ContactKind::open_boundary);
        const bool has_class = !specimen.contact_flaw.empty() && specimen.contact_flaw[c] > 0;
        if (has_class || !(is_open || kind == static_cast<std::uint8_t>(ContactKind::grain_boundary))) continue;
        boundaries[is_open].insert(std::minmax({crystal(specimen.contact_nodes[c][0]), crystal(specimen.contact_nodes[c][2])}));
        length[is_open] += contact_length(specimen, c);
    }
    const std::size_t n_open = boundaries[1].size();
    return n_open == 0 ? ""
                       : fmt::format("{} of {}, {:.4f} of their length", n_open, boundaries[0].size() + n_open,
                                     length[1] / (length[0] + length[1]));
}

std::string flaws_text(const Specimen& specimen) {
    struct Flaws {
        std::size_t contacts = 0, broken = 0;
        double length = 0;
    };
    std::vector<Flaws> classes(specimen.flaw_names.size() + 1);  // the first is without a class
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const std::size_t of_class = specimen.contact_flaw.empty() ? 0 : specimen.contact_flaw[c];
        const auto kind = static_cast<ContactKind>(specimen.contact_kind[c]);
        const bool is_crack = kind == ContactKind::pre_existing_crack;
        if (kind == ContactKind::within_crystal || (of_class == 0 && !is_crack)) continue;
        ++classes[of_class].contacts;
        classes[of_class].broken += is_crack ? 1 : 0;
        classes[of_class].length += contact_length(specimen, c);
    }
    std::string text;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const auto& [contacts, broken, length] = classes[i];
        if (contacts == 0) continue;
        const std::string state = broken == 0 ? "intact" : broken == contacts ? "broken" : fmt::format("{} broken", broken);
        text += fmt::format("{}{} {} contacts, {} long, {}", text.empty() ? "" : "; ",
                            i == 0 ? "cracks" : specimen.flaw_names[i - 1], contacts, format_length(length), state);
    }
    return text;
}

std::size_t number_of_crystals(const Specimen& specimen) {
    const std::vector<std::int32_t>& crystals = specimen.grain_crystal;
    if (crystals.empty()) return specimen.n_grains();
    return static_cast<std::size_t>(*std::max_element(crystals.begin(), crystals.end())) + 1;
}

double mean_crystal_diameter(const Specimen& specimen) {
    std::vector<double> areas(number_of_crystals(specimen), 0);
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) {
        const std::size_t crystal = specimen.grain_crystal.empty() ? g : static_cast<std::size_t>(specimen.grain_crystal[g]);
        areas[crystal] += specimen.grain_area[g];
    }
    double diameter = 0;
    for (const double area : areas) diameter += std::sqrt(4 * area / std::numbers::pi) / static_cast<double>(areas.size());
    return diameter;
}

std::string note_on_few_crystals(const Specimen& specimen) {
    const double diameter = mean_crystal_diameter(specimen);
    const double extent = std::min(specimen.width, specimen.height);
    constexpr int fewest_across = 10;            // crystals across a specimen whose strength is the material's
    constexpr double least_that_is_told = 9.95;  // smaller numbers are printed as less than `fewest_across`
    if (extent >= least_that_is_told * diameter) return "";
    const char* kind = specimen.tessellation == "delaunay" ? "grains" : "crystals";
    return fmt::format(
        "{:.2g} {} of the mean diameter across the smaller extent of {}: with fewer than {} a strength depends on "
        "single {} and is no material's",
        extent / diameter, kind, format_length(extent), fewest_across, kind);
}

}  // namespace graincrack
