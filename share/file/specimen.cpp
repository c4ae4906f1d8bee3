#include "share/file/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "share/base/error.hpp"
#include "share/base/quantities.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"

namespace graincrack {
namespace {

/// Calls `visit(dataset, array, rows, is_optional)` for each array; `rows` is nothing where an array tells how many rows others
/// have. An array that is optional has no dataset where it is empty.
template <class AnySpecimen, class Visit>
void visit_arrays(AnySpecimen& s, const Visit& visit) {
    visit(schema::node_position, s.node_position, std::nullopt, false);
    visit(schema::element_nodes, s.element_nodes, std::nullopt, false);
    visit(schema::element_grain, s.element_grain, s.n_elements(), false);
    visit(schema::grain_phase, s.grain_phase, std::nullopt, false);
    visit(schema::grain_area, s.grain_area, s.n_grains(), false);
    visit(schema::grain_crystal, s.grain_crystal, s.n_grains(), true);
    visit(schema::contact_nodes, s.contact_nodes, std::nullopt, false);
    visit(schema::contact_grain_boundary, s.contact_grain_boundary, s.n_contacts(), false);
    visit(schema::contact_kind, s.contact_kind, s.n_contacts(), false);
    visit(schema::contact_strength_factor, s.contact_strength_factor, s.n_contacts(), true);
    visit(schema::boundary_edges, s.boundary_edges, std::nullopt, false);
    visit(schema::boundary_part, s.boundary_part, s.n_boundary_edges(), false);
}

struct StatisticAttribute {
    const char* name;
    double MeshStatistics::*member;
    Dimension dimension;
};
constexpr StatisticAttribute statistic_attributes[] = {
    {"mean_edge", &MeshStatistics::mean_edge, Dimension::length},
    {"edge_variation", &MeshStatistics::edge_variation, Dimension::one},
    {"min_edge", &MeshStatistics::min_edge, Dimension::length},
    {"max_edge", &MeshStatistics::max_edge, Dimension::length},
    {"mean_diameter", &MeshStatistics::mean_diameter, Dimension::length},
    {"diameter_variation", &MeshStatistics::diameter_variation, Dimension::one},
    {"min_diameter", &MeshStatistics::min_diameter, Dimension::length},
    {"max_diameter", &MeshStatistics::max_diameter, Dimension::length},
    {"min_angle", &MeshStatistics::min_angle, Dimension::angle},
    {"psi6", &MeshStatistics::psi6, Dimension::one},
    {"area_error", &MeshStatistics::area_error, Dimension::one},
    {"elongation", &MeshStatistics::elongation, Dimension::one},
    {"elongation_angle", &MeshStatistics::elongation_angle, Dimension::angle},
};

/// Static VTKHDF 1.0: readers refuse 2D points and connectivity that is not a flat int64 list, so these are copies.
void write_vtk_view(H5Output& file, const Specimen& s) {
    const std::string group = schema::vtk_group;
    const std::int64_t n_nodes = static_cast<std::int64_t>(s.n_nodes());
    const std::int64_t n_elements = static_cast<std::int64_t>(s.n_elements());
    std::vector<std::array<double, 3>> points(s.n_nodes());
    std::transform(s.node_position.begin(), s.node_position.end(), points.begin(), [](const std::array<double, 2>& p) {
        return std::array<double, 3>{p[0], p[1], 0.0};
    });
    std::vector<std::int64_t> connectivity(flat(s.element_nodes).begin(), flat(s.element_nodes).end());
    std::vector<std::int64_t> offsets(s.n_elements() + 1);
    for (std::size_t e = 0; e < offsets.size(); ++e) offsets[e] = static_cast<std::int64_t>(3 * e);
    constexpr std::uint8_t vtk_triangle = 5;
    const std::vector<std::uint8_t> types(s.n_elements(), vtk_triangle);
    const auto scalar = [&](const char* name, std::int64_t value, std::string_view description) {
        file.write<std::int64_t>(group + "/" + name, std::span<const std::int64_t>(&value, 1), {1}, "1", description);
    };
    file.create_group(group);
    file.attribute(group, "Version", std::vector<std::int64_t>{1, 0});
    file.attribute(group, "Type", std::string("UnstructuredGrid"));
    scalar("NumberOfPoints", n_nodes, "number of points");
    scalar("NumberOfCells", n_elements, "number of cells");
    scalar("NumberOfConnectivityIds", 3 * n_elements, "length of Connectivity");
    file.write<double>(group + "/Points", flat(points), {points.size(), 3}, "m", "reference position x y 0");
    file.write<std::int64_t>(group + "/Connectivity", connectivity, {connectivity.size()}, "1", "nodes of the cells");
    file.write<std::int64_t>(group + "/Offsets", offsets, {offsets.size()}, "1", "first entry of each cell in Connectivity");
    file.write<std::uint8_t>(group + "/Types", types, {types.size()}, "1", "VTK cell type");
    file.hard_link(schema::element_grain.path, group + "/CellData/grain");
}

}  // namespace

std::vector<std::int32_t> grain_of_nodes(const Specimen& s) {
    std::vector<std::int32_t> grain(s.n_nodes(), -1);
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        for (const std::int32_t node : s.element_nodes[e]) grain[node] = s.element_grain[e];
    }
    return grain;
}

std::vector<std::string> contact_class_names(const Specimen& s) {
    std::vector<std::string> names;
    for (std::size_t high = 0; high < s.phase_names.size(); ++high) {
        for (std::size_t low = 0; low <= high; ++low) names.push_back(s.phase_names[low] + "-" + s.phase_names[high]);
    }
    names.insert(names.end(), s.flaw_names.begin(), s.flaw_names.end());
    return names;
}

bool is_flaw_name(std::string_view name) {
    const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    return !name.empty() && name.size() <= 40 && name[0] >= 'a' && name[0] <= 'z' && name != "broken" && name != "intact" &&
           std::all_of(name.begin(), name.end(), fits);
}

namespace {
constexpr std::string_view within_prefix = "within_";
}  // namespace

std::string within_class(std::string_view phase) { return std::string(within_prefix) + std::string(phase); }

std::string phase_of_within_class(std::string_view class_name) {
    return class_name.starts_with(within_prefix) ? std::string(class_name.substr(within_prefix.size())) : std::string();
}

std::vector<double> phase_fractions(const Specimen& s) {
    std::vector<double> fractions(s.phase_names.size());
    double whole = 0;
    for (std::size_t g = 0; g < s.n_grains(); ++g) {
        fractions[s.grain_phase[g]] += s.grain_area[g];
        whole += s.grain_area[g];
    }
    for (double& fraction : fractions) fraction /= whole;
    return fractions;
}

double contact_length(const Specimen& specimen, std::size_t contact) {
    const auto& nodes = specimen.contact_nodes[contact];
    const auto& from = specimen.node_position[static_cast<std::size_t>(nodes[0])];
    const auto& to = specimen.node_position[static_cast<std::size_t>(nodes[1])];
    return std::hypot(to[0] - from[0], to[1] - from[1]);
}

std::vector<std::uint8_t> contact_classes(const Specimen& s) {
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    std::vector<std::uint8_t> classes;
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto& nodes = s.contact_nodes[c];
        const std::size_t flaw = s.contact_flaw.empty() ? 0 : s.contact_flaw[c];
        classes.push_back(
            static_cast<std::uint8_t>(flaw == 0 ? contact_class(s.grain_phase[grain[nodes[0]]], s.grain_phase[grain[nodes[2]]])
                                                : n_contact_classes(s.phase_names.size()) + flaw - 1));
    }
    return classes;
}

void write_specimen(H5Output& file, const Specimen& s) {
    const std::string group = schema::specimen_group;
    file.create_group(group);
    file.attribute(group, "shape", s.shape);
    file.quantity(group, "width", s.width, "m");
    file.quantity(group, "height", s.height, "m");
    file.attribute(group, "tessellation", s.tessellation);
    file.attribute(group, "seed", static_cast<std::int64_t>(s.seed));
    file.attribute(group, "elements_per_edge", std::int64_t{s.elements_per_edge});
    file.quantity(group, "loading_arc", s.loading_arc, "rad");
    file.attribute(group, "grains", static_cast<std::int64_t>(s.n_grains()));
    for (const StatisticAttribute& a : statistic_attributes) {
        if (s.statistics.elongation == 0 && std::string_view(a.name).starts_with("elongation")) continue;  // not measured
        file.quantity(group, a.name, s.statistics.*a.member, si_unit(a.dimension));
    }
    visit_arrays(s, [&](const schema::Dataset& dataset, const auto& array, std::optional<std::size_t>, bool is_optional) {
        if (!array.empty() || !is_optional) write_rows(file, dataset, array);
    });
    file.attribute(schema::grain_phase.path, "names", s.phase_names);
    if (s.phase_names.size() > 1) file.attribute(schema::grain_phase.path, "fractions", phase_fractions(s));
    std::vector<std::string> kinds{"grain boundary", "pre-existing crack"};
    const bool any_open = std::find(s.contact_kind.begin(), s.contact_kind.end(),
                                    static_cast<std::uint8_t>(ContactKind::open_boundary)) != s.contact_kind.end();
    if (any_open || !s.grain_crystal.empty()) kinds.emplace_back("within a crystal");
    if (any_open) kinds.emplace_back("open boundary");
    file.attribute(schema::contact_kind.path, "names", kinds);
    if (const auto names = contact_class_names(s); names.size() > 1) {
        write_rows(file, schema::contact_class, contact_classes(s));
        file.attribute(schema::contact_class.path, "names", names);
    }
    file.attribute(schema::boundary_part.path, "names", s.part_names);
    write_vtk_view(file, s);
}

namespace {

/// The classes behind those of the phases are of flaws.
void read_flaws(const H5Input& file, const std::vector<std::uint8_t>& classes, Specimen& s) {
    const auto names = file.attribute_or<std::vector<std::string>>(schema::contact_class.path, "names", {});
    const std::size_t n_pairs = n_contact_classes(s.phase_names.size());
    if (names.size() <= n_pairs) return;
    s.flaw_names.assign(names.begin() + static_cast<std::ptrdiff_t>(n_pairs), names.end());
    for (const std::size_t k : classes) s.contact_flaw.push_back(static_cast<std::uint8_t>(k < n_pairs ? 0 : k - n_pairs + 1));
}

}  // namespace

Specimen read_specimen(const H5Input& file) {
    const std::string group = schema::specimen_group;
    Specimen s;
    s.shape = file.attribute<std::string>(group, "shape");
    s.width = file.attribute<double>(group, "width");
    s.height = file.attribute<double>(group, "height");
    s.tessellation = file.attribute_or<std::string>(group, "tessellation", "unknown");
    s.seed = static_cast<std::uint64_t>(file.attribute_or<std::int64_t>(group, "seed", 0));
    s.elements_per_edge = static_cast<int>(file.attribute_or<std::int64_t>(group, "elements_per_edge", 1));
    s.loading_arc = file.attribute_or<double>(group, "loading_arc", 0);
    for (const StatisticAttribute& a : statistic_attributes) s.statistics.*a.member = file.attribute_or<double>(group, a.name, 0);
    visit_arrays(s, [&]<class T>(const schema::Dataset& dataset, std::vector<T>& array, std::optional<std::size_t> rows,
                                 bool is_optional) {
        if (is_optional && !file.has(dataset.path)) return;
        const Extents own = file.extents(dataset.path);
        if (constexpr std::size_t width = Stored<T>::width; width > 1 && (own.size() != 2 || own[1] != width)) {
            throw InputError(fmt::format("{}: dataset {} needs {} columns", file.name(), dataset.path, width));
        }
        const std::size_t n = rows ? *rows : rows_of(file, dataset.path);
        array = rows_from<T>(file.read<typename Stored<T>::Number>(dataset.path, extents_of<T>(n)));
    });
    s.phase_names = file.attribute_or<std::vector<std::string>>(schema::grain_phase.path, "names", s.phase_names);
    s.part_names = file.attribute_or<std::vector<std::string>>(schema::boundary_part.path, "names", s.part_names);
    std::vector<std::uint8_t> classes;
    if (file.has(schema::contact_class.path)) {
        classes = file.read<std::uint8_t>(schema::contact_class.path, {s.n_contacts()});
        read_flaws(file, classes, s);
    }
    validate(s, file.name());
    if (!classes.empty() && classes != contact_classes(s)) {
        throw InputError(fmt::format("{}: {} is not the pair of the phases of the two grains of each contact", file.name(),
                                     schema::contact_class.path));
    }
    return s;
}

}  // namespace graincrack
