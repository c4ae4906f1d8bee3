#include "share/file/specimen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "share/base/error.hpp"
#include "share/base/quantities.hpp"
#include "share/file/datasets.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

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

// --- validation -----------------------------------------------------------------------------------------------------

namespace {

constexpr double tolerance = 0.01;   // relative error of sizes, areas and edges, by which the strength is also off
constexpr double off_centre = 1e-3;  // over a size: beyond it one platen would meet the specimen before the other
constexpr double conformity = 1e-9;  // over the specimen's size: far below any edge, far above round-off

constexpr std::array<std::string_view, 6> shapes{"rectangle", "disc", "ring", "beam", "half-disc", "polygon"};

double signed_area(const Specimen& s, const std::array<std::int32_t, 3>& e) {
    const auto& a = s.node_position[e[0]];
    const auto& b = s.node_position[e[1]];
    const auto& c = s.node_position[e[2]];
    return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
}

double distance(const Specimen& s, std::int32_t i, std::int32_t j) {
    return std::hypot(s.node_position[i][0] - s.node_position[j][0], s.node_position[i][1] - s.node_position[j][1]);
}

/// Throws the error of a violated condition, with the name of the file and the row.
class Checker {
public:
    explicit Checker(const std::string& where) : where_(where) {}
    void require(bool condition, const char* what, std::optional<std::size_t> row = {}) const {
        if (!condition) throw InputError(fmt::format("{}: {}{}", where_, what, row ? fmt::format(" (row {})", *row) : ""));
    }

private:
    const std::string& where_;
};

template <std::size_t n>
bool all_below(const std::array<std::int32_t, n>& row, std::size_t limit) {
    return std::all_of(row.begin(), row.end(), [limit](std::int32_t i) { return i >= 0 && static_cast<std::size_t>(i) < limit; });
}

void check_sizes(const Specimen& s, const Checker& check) {
    check.require(!s.element_nodes.empty(), "a specimen needs at least one element");
    check.require(s.element_grain.size() == s.n_elements(), "elements/nodes and elements/grain differ in length");
    check.require(s.grain_area.size() == s.n_grains(), "grains/area and grains/phase differ in length");
    check.require(s.contact_grain_boundary.size() == s.n_contacts(),
                  "contacts/grain_boundary and contacts/nodes differ in length");
    check.require(s.contact_kind.size() == s.n_contacts(), "contacts/kind and contacts/nodes differ in length");
    check.require(s.phase_names.size() <= max_phases, "more than 22 phases");
    for (const std::string& name : s.phase_names) check.require(name.size() <= 256, "a phase has a name of more than 256 bytes");
    check.require(s.contact_flaw.empty() || s.contact_flaw.size() == s.n_contacts(),
                  "classes of flaws and contacts/nodes differ in length");
    check.require(contact_class_names(s).size() <= max_classes, "more than 256 classes of contacts");
    for (const std::string& name : s.flaw_names) {
        check.require(is_flaw_name(name) && std::count(s.flaw_names.begin(), s.flaw_names.end(), name) == 1,
                      "the names of classes of flaws must differ, and be a letter and up to 39 of a-z, 0-9 and _");
    }
    for (std::size_t c = 0; c < s.contact_flaw.size(); ++c) {
        check.require(s.contact_flaw[c] <= s.flaw_names.size(), "contact names a class of flaws that does not exist", c);
    }
    check.require(s.contact_strength_factor.empty() || s.contact_strength_factor.size() == s.n_contacts(),
                  "contacts/strength_factor and contacts/nodes differ in length");
    for (std::size_t c = 0; c < s.contact_strength_factor.size(); ++c) {
        check.require(std::isfinite(s.contact_strength_factor[c]) && s.contact_strength_factor[c] > 0,
                      "contacts/strength_factor must be positive and finite", c);
    }
    check.require(s.boundary_part.size() == s.n_boundary_edges(), "boundary/part and boundary/edges differ in length");
    check.require(std::find(shapes.begin(), shapes.end(), s.shape) != shapes.end(),
                  "shape is unknown; rectangle, disc, ring, beam, half-disc or polygon is needed");
    check.require(s.height > 0 && s.width > 0 && std::isfinite(s.height) && std::isfinite(s.width),
                  "width and height must be positive and finite");
    check.require(s.loading_arc >= 0 && s.loading_arc < std::numbers::pi, "loading_arc must be from 0 to below π");
}

void check_elements(const Specimen& s, const Checker& check) {
    for (std::size_t i = 0; i < s.n_nodes(); ++i) {
        check.require(std::isfinite(s.node_position[i][0]) && std::isfinite(s.node_position[i][1]), "node position is not finite",
                      i);
    }
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        check.require(all_below(s.element_nodes[e], s.n_nodes()), "element names a node that does not exist", e);
        check.require(all_below(std::array{s.element_grain[e]}, s.n_grains()), "element names a grain that does not exist", e);
        check.require(signed_area(s, s.element_nodes[e]) > 0, "element is not counter-clockwise or has no area", e);
        check.require(e == 0 ? s.element_grain[e] == 0
                             : s.element_grain[e] == s.element_grain[e - 1] || s.element_grain[e] == s.element_grain[e - 1] + 1,
                      "elements must be sorted by grain, every grain with at least one", e);
    }
    check.require(s.element_grain.back() + 1 == static_cast<std::int32_t>(s.n_grains()), "a grain has no element");
    std::vector<std::int32_t> owner(s.n_nodes(), -1);
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        for (const std::int32_t node : s.element_nodes[e]) {
            check.require(owner[node] < 0 || owner[node] == s.element_grain[e],
                          "a node belongs to two grains; grains share no nodes", e);
            owner[node] = s.element_grain[e];
        }
    }
    std::vector<double> area(s.n_grains(), 0);
    for (std::size_t e = 0; e < s.n_elements(); ++e) area[s.element_grain[e]] += signed_area(s, s.element_nodes[e]);
    for (std::size_t g = 0; g < s.n_grains(); ++g) {
        check.require(std::abs(s.grain_area[g] - area[g]) <= tolerance * area[g],
                      "area of a grain is more than 1 % off that of its elements", g);
        check.require(s.grain_phase[g] < s.phase_names.size(), "grain names a phase that does not exist", g);
    }
}

/// Requires the declared size to be that of the mesh, centred on the origin, because platens, strains and stresses use it. The
/// outline of a disc is straight between its nodes; it deviates from the circle on each side by at most the rise of its longest
/// edge.
void check_size(const Specimen& s, const Checker& check) {
    double longest = 0;
    for (const auto& [i, j] : s.boundary_edges) longest = std::max(longest, distance(s, i, j));
    longest *= std::max(1, s.elements_per_edge);  // boundary edges of a grain edge are collinear
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        const auto [lowest, highest] = std::minmax_element(s.node_position.begin(), s.node_position.end(),
                                                           [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
        const double low = (*lowest)[axis];
        const double high = (*highest)[axis];
        const double declared = axis == 0 ? s.width : s.height;
        const double rise = s.shape == "rectangle" ? 0 : longest * longest / (2 * declared);
        check.require(high - low - rise <= (1 + tolerance) * declared && high - low + rise >= (1 - tolerance) * declared,
                      axis == 0 ? "width is more than 1 % off the extent of the nodes along x"
                                : "height is more than 1 % off the extent of the nodes along y");
        check.require(std::abs(low + high) / 2 <= off_centre * declared + rise / 2,
                      axis == 0 ? "the middle of the nodes along x is more than 0.1 % of the width off the origin"
                                : "the middle of the nodes along y is more than 0.1 % of the height off the origin");
    }
}

/// Requires a declared loading arc to be the angle under which the straight side at the top is seen from the centre.
void check_loading_arc(const Specimen& s, const Checker& check) {
    constexpr double off_straight = 1e-6;  // deviation of the nodes of that side, over the height
    double top = -s.height, side = 0;
    for (const auto& position : s.node_position) top = std::max(top, position[1]);
    const auto is_at_top = [&](std::int32_t node) { return s.node_position[node][1] >= top - off_straight * s.height; };
    for (const auto& [i, j] : s.boundary_edges) side += is_at_top(i) && is_at_top(j) ? distance(s, i, j) : 0;
    check.require(s.loading_arc == 0 || std::abs(2 * std::atan2(side, s.height) - s.loading_arc) <= tolerance * s.loading_arc,
                  "loading_arc is more than 1 % off the angle of the straight side at the top");
}

/// Requires a declared mean edge to be that of the contacts and the boundary or, if grains are neither triangles nor triangles of
/// n × n elements, the edge of the equilateral triangle of the grains' mean area.
void check_mean_edge(const Specimen& s, const Checker& check) {
    double length = 0;
    for (const auto& nodes : s.contact_nodes) length += distance(s, nodes[0], nodes[1]);
    for (const auto& [i, j] : s.boundary_edges) length += distance(s, i, j);
    const double mean = length * s.elements_per_edge / static_cast<double>(s.n_contacts() + s.n_boundary_edges());
    const double declared = s.statistics.mean_edge;
    const auto n_grains = static_cast<double>(s.n_grains());
    const bool are_triangles = static_cast<double>(s.n_elements()) == n_grains * s.elements_per_edge * s.elements_per_edge;
    double equilateral = 0;
    for (const double area : s.grain_area) equilateral += std::sqrt(4 * area / std::numbers::sqrt3) / n_grains;
    const bool is_of_areas = !are_triangles && std::abs(declared - equilateral) <= tolerance * equilateral;
    check.require(declared == 0 || is_of_areas || std::abs(declared - mean) <= tolerance * mean,
                  "mean_edge is more than 1 % off the mean edge of contacts and boundary");
}

/// Sides of the elements from node to node, counter-clockwise, sorted by the first node.
class ElementSides {
public:
    ElementSides(const Specimen& s, const Checker& check) : start_(s.n_nodes() + 1, 0), ends_(3 * s.n_elements()) {
        for (const auto& nodes : s.element_nodes) {
            for (const std::int32_t from : nodes) ++start_[from + 1];
        }
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
        for (const auto& [i, j, k] : s.element_nodes) {
            for (const auto& [from, to] : {std::pair{i, j}, std::pair{j, k}, std::pair{k, i}}) ends_[next[from]++].node = to;
        }
        for (std::size_t node = 0; node < s.n_nodes(); ++node) {
            check.require(start_[node] < start_[node + 1], "node is of no element", node);
            const auto first = ends_.begin() + static_cast<std::ptrdiff_t>(start_[node]);
            const auto last = ends_.begin() + static_cast<std::ptrdiff_t>(start_[node + 1]);
            std::sort(first, last, [](const End& a, const End& b) { return a.node < b.node; });
            check.require(std::adjacent_find(first, last, [](const End& a, const End& b) { return a.node == b.node; }) == last,
                          "two elements overlap: they have the same side from this node to the next", node);
        }
    }
    [[nodiscard]] bool has(std::int32_t from, std::int32_t to) const { return find(from, to) < ends_.size(); }
    /// Takes a side for a contact or the boundary. \return false if there is none, or it is within a grain or taken
    bool take(std::int32_t from, std::int32_t to) {
        const std::size_t side = find(from, to);
        return side < ends_.size() && !has(to, from) && !std::exchange(ends_[side].taken, true);
    }

private:
    struct End {
        std::int32_t node;
        bool taken = false;
    };
    /// Number of a side; the number of sides if there is none.
    [[nodiscard]] std::size_t find(std::int32_t from, std::int32_t to) const {
        const auto last = ends_.begin() + static_cast<std::ptrdiff_t>(start_[from + 1]);
        const auto end = std::lower_bound(ends_.begin() + static_cast<std::ptrdiff_t>(start_[from]), last, to,
                                          [](const End& e, std::int32_t node) { return e.node < node; });
        return end != last && end->node == to ? static_cast<std::size_t>(end - ends_.begin()) : ends_.size();
    }
    std::vector<std::size_t> start_;
    std::vector<End> ends_;
};

constexpr const char* taken = "a side must be on the outside of its grain, and once in contacts and boundary together";

/// Requires the grains of a crystal to have one phase.
void check_crystals(const Specimen& s, const Checker& check) {
    check.require(s.grain_crystal.empty() || s.grain_crystal.size() == s.n_grains(),
                  "grains/crystal and grains/phase differ in length");
    std::vector<int> phase(s.grain_crystal.size(), -1);
    for (std::size_t g = 0; g < s.grain_crystal.size(); ++g) {
        check.require(all_below(std::array{s.grain_crystal[g]}, s.n_grains()),
                      "grains/crystal is below 0 or above the number of grains", g);
        int& of_crystal = phase[static_cast<std::size_t>(s.grain_crystal[g])];
        check.require(of_crystal < 0 || of_crystal == s.grain_phase[g], "a crystal has grains of two phases", g);
        of_crystal = s.grain_phase[g];
    }
}

void check_contacts(const Specimen& s, ElementSides& sides, const Checker& check) {
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    const double slack = conformity * std::max(s.width, s.height);
    std::vector<bool> has_contact(s.n_grains(), s.n_contacts() == 0);
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto& [a1, a2, b1, b2] = s.contact_nodes[c];
        check.require(all_below(s.contact_nodes[c], s.n_nodes()), "contact names a node that does not exist", c);
        check.require(grain[a1] == grain[a2] && grain[b1] == grain[b2] && grain[a1] < grain[b1],
                      "contact must join an edge of grain a to one of grain b > a", c);
        check.require(a1 != a2 && distance(s, a1, b1) <= slack && distance(s, a2, b2) <= slack && distance(s, a1, a2) > slack,
                      "contact edges do not conform: a1 must lie on b1 and a2 on b2", c);
        check.require(sides.has(a1, a2) && sides.has(b2, b1),
                      "a1 to a2 must be the side of an element counter-clockwise around grain a, b2 to b1 one around b", c);
        check.require(sides.take(a1, a2) && sides.take(b2, b1), taken, c);
        check.require(s.contact_kind[c] <= static_cast<std::uint8_t>(ContactKind::open_boundary), "unknown kind of contact", c);
        const bool is_within = s.contact_kind[c] == static_cast<std::uint8_t>(ContactKind::within_crystal);
        check.require(!is_within || (!s.grain_crystal.empty() && s.grain_crystal[grain[a1]] == s.grain_crystal[grain[b1]]),
                      "a contact within a crystal must join two grains of one", c);
        has_contact[grain[a1]] = has_contact[grain[b1]] = true;
    }
    const auto alone = std::find(has_contact.begin(), has_contact.end(), false);
    check.require(alone == has_contact.end(), "grain has no contact", static_cast<std::size_t>(alone - has_contact.begin()));
}

void check_boundary(const Specimen& s, ElementSides& sides, const Checker& check) {
    for (std::size_t b = 0; b < s.n_boundary_edges(); ++b) {
        const auto& [from, to] = s.boundary_edges[b];
        check.require(all_below(s.boundary_edges[b], s.n_nodes()), "boundary edge names a node that does not exist", b);
        check.require(sides.has(from, to), "boundary edge is no side of an element with the solid on its left", b);
        check.require(sides.take(from, to), taken, b);
        check.require(s.boundary_part[b] < s.part_names.size(), "boundary edge names a part that does not exist", b);
    }
}

}  // namespace

void validate(const Specimen& specimen, const std::string& where) {
    const Checker check(where);
    check_sizes(specimen, check);
    check_elements(specimen, check);
    check_crystals(specimen, check);
    ElementSides sides(specimen, check);
    check_contacts(specimen, sides, check);
    check_boundary(specimen, sides, check);
    check_size(specimen, check);
    check_mean_edge(specimen, check);
    check_loading_arc(specimen, check);
}

// --- in a file ------------------------------------------------------------------------------------------------------

namespace {

/// Calls `visit(dataset, array, rows, is_optional)` for each array; `rows` is empty for an array that defines the number of rows
/// of others. An optional array has no dataset if it is empty.
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

/// Writes a static VTKHDF 1.0 view: readers refuse 2D points and connectivity other than a flat int64 list, so these are copies.
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

void visit_specimen_datasets(const VisitDataset& visit) {
    const Specimen none;
    visit_arrays(none, [&](const schema::Dataset& dataset, const auto&... /*array*/) { visit(dataset); });
    visit(schema::contact_class);
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
    if (!s.settings.empty()) write_settings(file, group, s.settings);
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

/// Reads the classes of flaws, which follow those of the phases.
void read_flaws(const std::vector<std::string>& names, const std::vector<std::uint8_t>& classes, Specimen& s) {
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
    s.settings = read_settings(file, group);
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
    std::vector<std::string> class_names;
    if (file.has(schema::contact_class.path)) {
        classes = file.read<std::uint8_t>(schema::contact_class.path, {s.n_contacts()});
        class_names = file.attribute_or<std::vector<std::string>>(schema::contact_class.path, "names", {});
        read_flaws(class_names, classes, s);
    }
    validate(s, file.name());
    const auto require = [&](bool holds, const std::string& wrong) {
        if (!holds) throw InputError(fmt::format("{}: {}", file.name(), wrong));
    };
    const std::string of_classes = schema::contact_class.path;
    require(classes.empty() || classes == contact_classes(s),
            of_classes + " is not the pair of the phases of the two grains of each contact");
    require(class_names.empty() || class_names == contact_class_names(s),
            fmt::format("the names of {} are not {}", of_classes, fmt::join(contact_class_names(s), ", ")));
    const auto n_grains = static_cast<std::int64_t>(s.n_grains());
    const auto declared = file.attribute_or<std::int64_t>(group, "grains", n_grains);
    require(declared == n_grains, fmt::format("{}: grains is {}, and there are {}", group, declared, n_grains));
    return s;
}

}  // namespace graincrack
