// The specimen in a file, and the conventions that it must satisfy.
#include "share/file/specimen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

using test::TemporaryFolder;

/// Two cells, two grains of two triangles each, one contact: 0.2 × 0.1 m.
Specimen two_squares() {
    return test::specimen_of_grains({{-0.1, -0.05}, {0, -0.05}, {0.1, -0.05}, {-0.1, 0.05}, {0, 0.05}, {0.1, 0.05}},
                                    {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}, {0, 0, 1, 1});
}

TEST(Specimen, KeepsTheConventionsIfMadeByHand) {
    for (const Specimen& s : {two_squares(), test::one_diagonal_grid(2, 3, 0.02, 0.03), test::union_jack_grid(4, 4, 1, 1),
                              test::jittered_grid(4, 8, 0.04, 0.08, 0.2)}) {
        EXPECT_NO_THROW(validate(s, "hand"));
    }
    const Specimen s = two_squares();
    EXPECT_EQ(s.n_contacts(), 1U);
    EXPECT_EQ(s.n_boundary_edges(), 6U);
    EXPECT_EQ(std::count(s.boundary_part.begin(), s.boundary_part.end(), static_cast<std::uint8_t>(BoundaryPart::top)), 2);
}

TEST(Specimen, ComesBackFromAFile) {
    const TemporaryFolder folder;
    Specimen s = test::jittered_grid(3, 4, 0.03, 0.04, 0.2);
    s.shape = "rectangle";
    s.seed = 12345;
    s.elements_per_edge = 2;
    s.loading_arc = 2 * std::atan2(0.03, 0.04);
    s.statistics = {2 * s.statistics.mean_edge, 0.1, 0.003, 0.005, 0.0038, 0.12, 0.003, 0.0045, 0.6, 0.05, 1e-15};
    s.phase_names = {"quartz", "feldspar"};
    s.grain_phase[1] = 1;
    s.grain_crystal.resize(s.n_grains());
    std::iota(s.grain_crystal.begin(), s.grain_crystal.end(), 0);
    s.part_names.push_back("notch");
    s.boundary_part[0] = 5;
    s.contact_kind[2] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
    const auto written = [&folder](const std::string& name, const Specimen& specimen) {
        H5Output out(folder.file(name), "specimen");
        write_specimen(out, specimen);
        out.commit();
        return H5Input(folder.file(name), "specimen");
    };
    const H5Input in = written("s.h5", s);
    const Specimen r = read_specimen(in);
    EXPECT_EQ(written("again.h5", r).digest(), in.digest()) << "what is read is what was written";
    EXPECT_EQ(r.grain_crystal, s.grain_crystal);
    EXPECT_EQ(r.seed, s.seed);
    EXPECT_EQ(r.statistics.max_diameter, 0.0045);
    EXPECT_EQ(r.node_position, s.node_position);
    EXPECT_EQ(r.contact_nodes, s.contact_nodes);
    EXPECT_EQ(r.boundary_part, s.boundary_part);
    EXPECT_EQ(r.part_names, s.part_names);
    // The copy for VTK.
    EXPECT_EQ(in.attribute<std::string>(schema::vtk_group, "Type"), "UnstructuredGrid");
    EXPECT_EQ(in.attribute<std::vector<std::int64_t>>(schema::vtk_group, "Version"), (std::vector<std::int64_t>{1, 0}));
    EXPECT_EQ(in.extents("/VTKHDF/Points"), (Extents{s.n_nodes(), 3}));
    const auto offsets = in.read<std::int64_t>("/VTKHDF/Offsets");
    ASSERT_EQ(offsets.size(), s.n_elements() + 1);
    EXPECT_EQ(offsets.back(), static_cast<std::int64_t>(3 * s.n_elements()));
    EXPECT_EQ(in.read<std::int32_t>("/VTKHDF/CellData/grain"), s.element_grain);
}

TEST(Specimen, HasNodesOfGrains) {
    Specimen s = two_squares();
    s.node_position.push_back({0.02, 0.02});  // a node of no element
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    EXPECT_EQ(std::count(grain.begin(), grain.end(), 0), 4);
    EXPECT_EQ(std::count(grain.begin(), grain.end(), 1), 4);
    EXPECT_EQ(grain.back(), -1);
}

TEST(Specimen, HasTheDeclaredSize) {
    test::GoldenRefusals refused;
    for (const double factor : {0.5, 0.985, 1.009, 1.015, 2.0}) {
        for (double Specimen::*size : {&Specimen::height, &Specimen::width}) {
            Specimen s = two_squares();
            s.*size *= factor;
            const auto check = [&] { validate(s, "s.h5"); };
            factor == 1.009 ? check() : refused.add<InputError>("size", check);
        }
    }
}

void add_boundary_edge(Specimen& s, std::int32_t from, std::int32_t to, std::uint8_t part) {
    s.boundary_edges.push_back({from, to});
    s.boundary_part.push_back(part);
}

/// The first contact with some of its nodes.
void take_nodes(Specimen& s, std::size_t a1, std::size_t a2, std::size_t b1, std::size_t b2) {
    const auto nodes = s.contact_nodes[0];
    s.contact_nodes[0] = {nodes[a1], nodes[a2], nodes[b1], nodes[b2]};
}

void move_nodes(Specimen& s, std::size_t axis, double by) {
    for (auto& p : s.node_position) p[axis] += by;
}

/// The first grain again, as the last.
void repeat_grain(Specimen& s) {
    const auto first_node = static_cast<std::int32_t>(s.n_nodes());
    const std::size_t n_elements = s.n_elements();
    for (std::size_t e = 0; e < n_elements && s.element_grain[e] == 0; ++e) {
        for (const std::int32_t node : s.element_nodes[e]) s.node_position.push_back(s.node_position[node]);
        const auto next = static_cast<std::int32_t>(s.n_nodes());
        s.element_nodes.push_back({next - 3, next - 2, next - 1});
        s.element_grain.push_back(static_cast<std::int32_t>(s.n_grains()));
    }
    add_boundary_edge(s, first_node, first_node + 1, 0);
    s.grain_phase.push_back(0);
    s.grain_area.push_back(s.grain_area[0]);
}

/// Changes that make a specimen invalid.
using Offence = std::pair<const char*, std::function<void(Specimen&)>>;

const std::vector<Offence>& offences() {
    static const std::vector<Offence> list{
        {"no element",
         [](Specimen& s) {
             s.element_nodes.clear();
             s.element_grain.clear();
         }},
        {"lengths of /elements", [](Specimen& s) { s.element_grain.pop_back(); }},
        {"lengths of /grains", [](Specimen& s) { s.grain_area.pop_back(); }},
        {"lengths of /contacts", [](Specimen& s) { s.contact_grain_boundary.clear(); }},
        {"lengths of kinds", [](Specimen& s) { s.contact_kind.push_back(0); }},
        {"lengths of /boundary", [](Specimen& s) { s.boundary_part.pop_back(); }},
        {"height", [](Specimen& s) { s.height = 0; }},
        {"width", [](Specimen& s) { s.width = -0.1; }},
        {"NaN width", [](Specimen& s) { s.width = std::numeric_limits<double>::quiet_NaN(); }},
        {"NaN position", [](Specimen& s) { s.node_position[3][1] = std::numeric_limits<double>::quiet_NaN(); }},
        {"infinite position", [](Specimen& s) { s.node_position[0][0] = std::numeric_limits<double>::infinity(); }},
        {"negative node of an element", [](Specimen& s) { s.element_nodes[0][0] = -1; }},
        {"node of an element beyond the last", [](Specimen& s) { s.element_nodes[2][1] = 8; }},
        {"grain beyond the last", [](Specimen& s) { s.element_grain[3] = 2; }},
        {"negative grain", [](Specimen& s) { s.element_grain[0] = -1; }},
        {"clockwise element", [](Specimen& s) { std::swap(s.element_nodes[1][1], s.element_nodes[1][2]); }},
        {"element without area", [](Specimen& s) { s.element_nodes[1][1] = s.element_nodes[1][2]; }},
        {"grains out of order",
         [](Specimen& s) {
             std::swap(s.element_grain[1], s.element_grain[2]);
             std::swap(s.element_nodes[1], s.element_nodes[2]);
         }},
        {"first grain is not 0", [](Specimen& s) { s.element_grain[0] = s.element_grain[1] = 1; }},
        {"grain without element",
         [](Specimen& s) {
             s.grain_phase.push_back(0);
             s.grain_area.push_back(0);
         }},
        {"node shared by grains",
         [](Specimen& s) {
             const auto& contact = s.contact_nodes[0];
             for (auto& nodes : s.element_nodes) std::replace(nodes.begin(), nodes.end(), contact[2], contact[0]);
         }},
        {"element twice",
         [](Specimen& s) {
             s.element_nodes.push_back(s.element_nodes.back());
             s.element_grain.push_back(s.element_grain.back());
             s.grain_area[1] *= 1.5;
         }},
        {"node of no element", [](Specimen& s) { s.node_position.emplace_back(); }},
        {"crystals of too few grains", [](Specimen& s) { s.grain_crystal = {0}; }},
        {"crystal below 0", [](Specimen& s) { s.grain_crystal.assign(2, -1); }},
        {"crystal of two phases",
         [](Specimen& s) {
             s.phase_names = {"quartz", "mica"};
             s.grain_phase = {0, 1};
             s.grain_crystal.assign(2, 1);
         }},
        {"contact within no crystal", [](Specimen& s) { s.contact_kind[0] = 2; }},
        {"contact within two crystals",
         [](Specimen& s) {
             s.grain_crystal = {0, 1};
             s.contact_kind[0] = 2;
         }},
        {"grain twice", repeat_grain},
        {"area that is not that of the elements", [](Specimen& s) { s.grain_area[1] *= 1.02; }},
        {"NaN area", [](Specimen& s) { s.grain_area[1] = std::numeric_limits<double>::quiet_NaN(); }},
        {"mean edge that is not that of the mesh", [](Specimen& s) { s.statistics.mean_edge *= 1.02; }},
        {"edges per grain edge", [](Specimen& s) { s.elements_per_edge = 2; }},
        {"unknown shape", [](Specimen& s) { s.shape = "hexagon"; }},
        {"negative arc", [](Specimen& s) { s.loading_arc = -0.1; }},
        {"arc in degrees", [](Specimen& s) { s.loading_arc = 8; }},
        {"arc of another side", [](Specimen& s) { s.loading_arc = 1.02 * 2 * std::atan2(s.width, s.height); }},
        {"middle off the origin", [](Specimen& s) { move_nodes(s, 1, 0.0011 * s.height); }},
        {"middle off the origin along x", [](Specimen& s) { move_nodes(s, 0, -0.0011 * s.width); }},
        {"contact twice",
         [](Specimen& s) {
             s.contact_nodes.push_back(s.contact_nodes[0]);
             s.contact_grain_boundary.push_back(1);
             s.contact_kind.push_back(0);
         }},
        {"boundary edge twice",
         [](Specimen& s) { add_boundary_edge(s, s.boundary_edges[2][0], s.boundary_edges[2][1], s.boundary_part[2]); }},
        {"contact in the boundary too",
         [](Specimen& s) { add_boundary_edge(s, s.contact_nodes[0][0], s.contact_nodes[0][1], 4); }},
        {"inside of a grain as boundary",
         [](Specimen& s) { add_boundary_edge(s, s.element_nodes[0][2], s.element_nodes[0][0], 4); }},
        {"unknown phase", [](Specimen& s) { s.grain_phase[1] = 1; }},
        {"contact with a node that is not there", [](Specimen& s) { s.contact_nodes[0][3] = 99; }},
        {"grain a above grain b", [](Specimen& s) { take_nodes(s, 3, 2, 1, 0); }},
        {"contact within a grain", [](Specimen& s) { take_nodes(s, 0, 1, 0, 3); }},
        {"contact turned about: a1→a2 clockwise around a", [](Specimen& s) { take_nodes(s, 1, 0, 3, 2); }},
        {"contact of crossed edges", [](Specimen& s) { take_nodes(s, 0, 1, 3, 2); }},
        {"contact with a gap",
         [](Specimen& s) {
             for (const std::size_t k : {2U, 3U}) s.node_position[s.contact_nodes[0][k]][0] += 1e-8 * s.width;
         }},
        {"contact without length", [](Specimen& s) { take_nodes(s, 0, 0, 2, 2); }},
        {"unknown kind of contact", [](Specimen& s) { s.contact_kind[0] = 4; }},
        {"boundary node that is not there", [](Specimen& s) { s.boundary_edges[4][1] = -2; }},
        {"boundary edge with the solid on its right",
         [](Specimen& s) { std::swap(s.boundary_edges[0][0], s.boundary_edges[0][1]); }},
        {"unknown part", [](Specimen& s) { s.boundary_part[1] = 9; }},
    };
    return list;
}

TEST(Specimen, IsRefusedForEveryBrokenConvention) {
    test::GoldenRefusals refused;
    for (const auto& [what, commit] : offences()) {
        Specimen s = two_squares();
        commit(s);
        refused.add<InputError>(what, [&] { validate(s, "broken.h5"); });
    }
}

/// Reads two squares back from a file that `change` has damaged.
void read_changed(const std::function<void(H5Output&)>& change) {
    const TemporaryFolder folder;
    Specimen s = two_squares();
    s.phase_names = {"quartz", "mica"};
    H5Output out(folder.file("s.h5"), "specimen");
    write_specimen(out, s);
    change(out);
    out.commit();
    read_specimen(H5Input(folder.file("s.h5")));
}

TEST(Specimen, IsComparedWithWhatItsFileSaysTwiceAsItIsRead) {
    using Names = std::vector<std::string>;
    const std::vector<std::function<void(H5Output&)>> changes{
        [](H5Output& out) { out.attribute("/specimen", "grains", std::int64_t{3}); },
        [](H5Output& out) {
            out.attribute("/contacts/class", "names", Names{"quartz-quartz", "mica-mica", "quartz-mica"});
        },
        [](H5Output& out) { out.attribute("/contacts/class", "names", Names{"quartz"}); },
        [](H5Output& out) { out.remove("/contacts/nodes"); },
        [](H5Output& out) {
            out.remove("/nodes/position");
            out.write<double>("/nodes/position", std::vector<double>(24, 0.0), {8, 3}, "m", "three columns");
        },
        [](H5Output& out) {
            out.remove("/elements/nodes");
            out.write<std::int32_t>("/elements/nodes", std::vector<std::int32_t>(12, 0), {12}, "1", "flat");
        },
        [](H5Output& out) {
            out.remove("/contacts/kind");
            out.write<std::uint8_t>("/contacts/kind", std::vector<std::uint8_t>{7}, {1}, "1", "of no kind");
        }};
    test::GoldenRefusals refused;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        refused.add<InputError>(std::to_string(i), [&] { read_changed(changes[i]); });
    }
}

}  // namespace
}  // namespace graincrack
