#include "post/export/mesh_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <string_view>

#include "share/base/text.hpp"
#include "share/base/union_find.hpp"

namespace graincrack {

namespace {

/// Appends a line of numbers, each in the fewest digits that read back exactly.
template <class... Numbers>
void append_line(std::string& text, Numbers... numbers) {
    const auto one = [&](auto number) {
        std::array<char, 32> digits{};
        text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
        text += ' ';
    };
    (one(numbers), ...);
    text.back() = '\n';
}

/// A name for Gmsh, without quotes and control characters.
std::string gmsh_name(std::string_view name) {
    std::string shown = printable(name);
    std::replace(shown.begin(), shown.end(), '"', '\'');
    return shown;
}

std::size_t n_crystals(const SharedMesh& mesh) {
    const auto last = std::max_element(mesh.grain_crystal.begin(), mesh.grain_crystal.end());
    return last == mesh.grain_crystal.end() ? 0 : static_cast<std::size_t>(*last) + 1;
}

}  // namespace

std::string gmsh_text(const SharedMesh& mesh) {
    const std::size_t n_phases = mesh.phase_names.size();
    const std::size_t n_entities = n_crystals(mesh);
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    text += fmt::format("$PhysicalNames\n{}\n", n_phases + mesh.side_names.size());
    const auto name = [&](int dimension, std::size_t number, const std::string& of) {
        text += fmt::format("{} {} \"{}\"\n", dimension, number, gmsh_name(of));
    };
    for (std::size_t p = 0; p < n_phases; ++p) name(2, p + 1, mesh.phase_names[p]);
    for (std::size_t i = 0; i < mesh.side_names.size(); ++i) name(1, n_phases + i + 1, mesh.side_names[i]);
    text += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n", mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) append_line(text, i + 1, mesh.points[i][0], mesh.points[i][1], 0);
    text += fmt::format("$EndNodes\n$Elements\n{}\n", mesh.triangles.size() + mesh.sides.size());
    constexpr int line_type = 1;
    constexpr int triangle_type = 2;
    constexpr int n_tags = 2;
    std::size_t number = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto grain = static_cast<std::size_t>(mesh.triangle_grain[t]);
        const auto& [i, j, k] = mesh.triangles[t];
        append_line(text, ++number, triangle_type, n_tags, mesh.grain_phase[grain] + 1, mesh.grain_crystal[grain] + 1, i + 1,
                    j + 1, k + 1);
    }
    for (const NamedSide& side : mesh.sides) {
        append_line(text, ++number, line_type, n_tags, n_phases + side.name + 1, n_entities + side.name + 1, side.from + 1,
                    side.to + 1);
    }
    return text + "$EndElements\n";
}

std::vector<std::string> losses(const SharedMesh& mesh) {
    std::vector<std::string> left_out;
    if (mesh.has_strength_factors) {
        left_out.push_back(fmt::format(
            "strength factors of contacts (import --seed {} draws them again with their modulus or material)", mesh.seed));
    }
    if (mesh.has_crystals && mesh.triangles.size() > mesh.grain_phase.size()) {
        left_out.emplace_back("grains of several elements within crystals");
    }
    std::vector<std::string> lost;
    if (!left_out.empty()) lost.push_back(fmt::format("leaves out {}", fmt::join(left_out, ", ")));
    for (const auto* names : {&mesh.phase_names, &mesh.side_names}) {
        for (const std::string& name : *names) {
            const std::string written = gmsh_name(name);
            if (written != name) lost.push_back(fmt::format("has {} for the name {}", written, printable(name)));
        }
    }
    return lost;
}

namespace {

/// Returns the point of each node and adds the points to the mesh.
std::vector<std::int32_t> join_nodes(const Specimen& s, SharedMesh& mesh) {
    UnionFind sets(s.n_nodes());
    for (const auto& [a1, a2, b1, b2] : s.contact_nodes) {
        sets.join(static_cast<std::size_t>(a1), static_cast<std::size_t>(b1));
        sets.join(static_cast<std::size_t>(a2), static_cast<std::size_t>(b2));
    }
    std::vector<std::int32_t> point(s.n_nodes());
    for (std::size_t node = 0; node < s.n_nodes(); ++node) {
        const std::size_t lowest = sets.find(node);
        if (lowest == node) {
            point[node] = static_cast<std::int32_t>(mesh.points.size());
            mesh.points.push_back(s.node_position[node]);
        } else {
            point[node] = point[lowest];
        }
    }
    return point;
}

/// All possible names of sides: those of the parts, then two for each class of flaws. The first class is "no class": open
/// boundaries and cracks.
std::vector<std::string> all_side_names(const Specimen& s) {
    std::vector<std::string> names = s.part_names;
    names.insert(names.end(), {"open-boundary", "crack"});  // other grain boundaries have no name
    for (const std::string& flaw : s.flaw_names) names.insert(names.end(), {"flaw-" + flaw, "flaw-" + flaw + "-broken"});
    return names;
}

/// Keeps the names in use; equal names become one.
void keep_used_names(SharedMesh& mesh, const std::vector<std::string>& names) {
    std::vector<bool> is_used(names.size(), false);
    for (const NamedSide& side : mesh.sides) is_used[side.name] = true;
    std::vector<std::size_t> kept(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!is_used[i]) continue;
        const auto equal = std::find(mesh.side_names.begin(), mesh.side_names.end(), names[i]);
        kept[i] = static_cast<std::size_t>(equal - mesh.side_names.begin());
        if (equal == mesh.side_names.end()) mesh.side_names.push_back(names[i]);
    }
    for (NamedSide& side : mesh.sides) side.name = kept[side.name];
}

}  // namespace

SharedMesh share_nodes(const Specimen& s) {
    SharedMesh mesh;
    const std::vector<std::int32_t> point = join_nodes(s, mesh);
    const auto point_of = [&](std::int32_t node) { return point[static_cast<std::size_t>(node)]; };
    for (const auto& [i, j, k] : s.element_nodes) mesh.triangles.push_back({point_of(i), point_of(j), point_of(k)});
    mesh.triangle_grain = s.element_grain;
    mesh.grain_phase = s.grain_phase;
    mesh.phase_names = s.phase_names;
    mesh.has_strength_factors = !s.contact_strength_factor.empty();
    mesh.has_crystals = !s.grain_crystal.empty();
    mesh.grain_crystal = s.grain_crystal;
    if (!mesh.has_crystals) {
        mesh.grain_crystal.resize(s.n_grains());
        std::iota(mesh.grain_crystal.begin(), mesh.grain_crystal.end(), 0);
    }
    mesh.seed = s.seed;
    for (std::size_t b = 0; b < s.n_boundary_edges(); ++b) {
        const auto& [from, to] = s.boundary_edges[b];
        mesh.sides.push_back({point_of(from), point_of(to), s.boundary_part[b]});
    }
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const std::size_t flaw = s.contact_flaw.empty() ? 0 : s.contact_flaw[c];
        const bool is_broken = s.contact_kind[c] == static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
        const bool is_within = s.contact_kind[c] == static_cast<std::uint8_t>(ContactKind::within_crystal);  // crystals show it
        if (is_within || (flaw == 0 && !starts_broken(s.contact_kind[c]))) continue;
        const auto& nodes = s.contact_nodes[c];
        mesh.sides.push_back({point_of(nodes[0]), point_of(nodes[1]), s.part_names.size() + 2 * flaw + (is_broken ? 1 : 0)});
    }
    keep_used_names(mesh, all_side_names(s));
    return mesh;
}

}  // namespace graincrack
