#include "post/run/crystals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>

#include "share/file/file_checks.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

std::size_t crystal_of(const Specimen& specimen, std::size_t grain) {
    return specimen.grain_crystal.empty() ? grain : static_cast<std::size_t>(specimen.grain_crystal[grain]);
}

std::vector<std::array<std::size_t, 2>> grains_of_contacts(const Specimen& specimen) {
    const std::vector<std::int32_t> grain = grain_of_nodes(specimen);
    std::vector<std::array<std::size_t, 2>> grains;
    for (const auto& [a1, a2, b1, b2] : specimen.contact_nodes) {
        grains.push_back({static_cast<std::size_t>(grain[static_cast<std::size_t>(a1)]),
                          static_cast<std::size_t>(grain[static_cast<std::size_t>(b1)])});
    }
    return grains;
}

bool is_within_crystal(const Specimen& specimen, std::size_t contact) {
    return specimen.contact_kind[contact] == static_cast<std::uint8_t>(ContactKind::within_crystal);
}

std::string grains_label(const Specimen& specimen) {
    if (specimen.grain_crystal.empty()) return fmt::format("{} grains", specimen.n_grains());
    return fmt::format("{} crystals of {} elements", number_of_crystals(specimen), specimen.n_grains());
}

std::string asked_grains(const H5Input& file) {
    const Settings settings = read_settings(file, schema::specimen_group);
    std::string text = text_of(settings, "tessellation");
    if (text.empty()) return "";
    const double elongation = number_of(settings, "elongation");
    for (const char* name : {"grains", "edge", "spread", "grade", "grade_relative_edges", "elements_per_crystal", "element_size",
                             "elongation", "elongation_angle"}) {
        const Setting* const setting = find_setting(settings, name);
        const bool is_given = setting != nullptr && !std::holds_alternative<std::monostate>(setting->value);
        const bool is_equiaxed = elongation == 1 && std::string_view(name).starts_with("elongation");
        if (is_given && !is_equiaxed) text += fmt::format(", {} {}", option_name(*setting), shown(*setting));
    }
    const std::string material = text_of(settings, "material");
    return material.empty() ? text : fmt::format("{} (material {})", text, material);
}

std::optional<CrystalSizes> crystal_sizes(const H5Input& file) {
    const auto tessellation = file.attribute_or<std::string>(schema::specimen_group, "tessellation", "");
    const bool has_crystals = tessellation == "voronoi" || tessellation == "trigon" || file.has(schema::grain_crystal.path);
    return has_crystals ? sizes_of_grains(file) : std::nullopt;
}

std::optional<CrystalSizes> sizes_of_grains(const H5Input& file) {
    if (!file.has(schema::grain_area.path)) return std::nullopt;
    const auto areas = file.read<double>(schema::grain_area.path);
    std::vector<std::int32_t> crystals;
    if (file.has(schema::grain_crystal.path)) crystals = file.read<std::int32_t>(schema::grain_crystal.path);
    std::map<std::int64_t, double> area;
    for (std::size_t grain = 0; grain < areas.size(); ++grain) {
        area[grain < crystals.size() ? crystals[grain] : static_cast<std::int64_t>(grain)] += areas[grain];
    }
    if (area.empty()) return std::nullopt;
    CrystalSizes sizes;
    sizes.n = area.size();
    const auto n = static_cast<double>(sizes.n);
    double squares = 0;
    for (const auto& [crystal, a] : area) {
        const double diameter = std::sqrt(4 * a / std::numbers::pi);
        sizes.mean_diameter += diameter / n;
        sizes.area += a;
        squares += diameter * diameter / n;
    }
    sizes.variation = std::sqrt(std::max(0.0, squares - sizes.mean_diameter * sizes.mean_diameter)) / sizes.mean_diameter;
    sizes.elements = static_cast<double>(rows_of(file, schema::element_nodes.path)) / n;
    return sizes;
}

}  // namespace graincrack
