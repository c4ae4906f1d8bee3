#include "post/export/mesh_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

#include "tests/support/golden.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack {
namespace {

/// Two grains of two minerals, one of two triangles, with a crack between them.
SharedMesh two_grains() {
    Specimen s = test::specimen_of_grains({{-0.1, 0}, {0.1, 0}, {0.1, 0.1}, {-0.1, 0.1}, {0, -0.1}},
                                          {{0, 1, 2}, {0, 2, 3}, {4, 1, 0}}, {0, 0, 1});
    s.phase_names = {"quartz", "mica"};
    s.grain_phase = {0, 1};
    test::break_contacts(s, [](double, double) { return true; });
    return share_nodes(s);
}

TEST(MeshFile, IsMsh2) { test::expect_golden(gmsh_text(two_grains())); }

TEST(MeshFile, HasCoordinatesThatReadBackExactly) {
    Specimen s = test::jittered_grid(9, 9, 0.1 / 3, std::numbers::pi / 100, 0.2);
    s.node_position[0][0] = -0.0;
    s.node_position[1][1] = 5e-324;
    const SharedMesh mesh = share_nodes(s);
    const std::string text = gmsh_text(mesh), head = "$Nodes\n";
    std::istringstream nodes(text.substr(text.find(head) + head.size()));
    std::size_t number = 0;
    nodes >> number;
    ASSERT_EQ(number, mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        std::array<std::string, 3> words;
        nodes >> number >> words[0] >> words[1] >> words[2];
        EXPECT_EQ(number, i + 1);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            double value = 1;
            const char* const end = words[axis].data() + words[axis].size();
            EXPECT_EQ(std::from_chars(words[axis].data(), end, value).ptr, end);
            EXPECT_EQ(value, mesh.points[i][axis]);
            EXPECT_EQ(std::signbit(value), std::signbit(mesh.points[i][axis]));
        }
    }
}

TEST(MeshFile, TellsWhatItsFormatDoesNotCarry) {
    SharedMesh mesh = two_grains();
    EXPECT_TRUE(losses(mesh).empty());
    mesh.has_strength_factors = true;
    mesh.phase_names = {"Feldspat, weiß", "brown \"mica\"\n"};
    std::string told;
    for (const std::string& loss : losses(mesh)) told += loss + "\n";
    test::expect_golden(told);
    const std::string text = gmsh_text(mesh);
    test::expect_golden(text.substr(0, text.find("$EndPhysicalNames")), "names");
}

TEST(MeshFile, HasAnEntityForEachCrystalOfSeveralGrains) {
    Specimen s = test::one_diagonal_grid(2, 1, 0.2, 0.1);
    s.grain_crystal = {0, 0, 1, 1};
    s.flaw_names = {"within_rock"};
    s.contact_flaw.assign(s.n_contacts(), 0);
    s.contact_flaw[0] = 1;
    s.contact_kind[0] = static_cast<std::uint8_t>(ContactKind::within_crystal);
    const SharedMesh mesh = share_nodes(s);
    EXPECT_TRUE(losses(mesh).empty());
    EXPECT_EQ(mesh.sides.size(), s.n_boundary_edges()) << "contacts within crystals follow from the crystals";
    test::expect_golden(gmsh_text(mesh), "mesh");
    s.element_grain = {0, 0, 1, 1};
    s.grain_phase.resize(2);
    s.grain_crystal = {0, 0};
    ASSERT_EQ(losses(share_nodes(s)).size(), 1U);
    test::expect_golden(losses(share_nodes(s)).front());
}

/// Fails unless the ends of a side are at two nodes of the specimen.
void expect_at(const SharedMesh& mesh, const NamedSide& side, const Specimen& s, std::int32_t from, std::int32_t to) {
    EXPECT_EQ(mesh.points[static_cast<std::size_t>(side.from)], s.node_position[static_cast<std::size_t>(from)]);
    EXPECT_EQ(mesh.points[static_cast<std::size_t>(side.to)], s.node_position[static_cast<std::size_t>(to)]);
}

TEST(SharedMesh, HasPointsWhereTheirLowestNodesLie) {
    Specimen s = test::one_diagonal_grid(1, 1, 0.2, 0.1);  // six nodes at four places
    const auto lowest = s.node_position[0];
    s.node_position[3][0] += 1e-12;  // of the other grain, within what a contact may be off
    EXPECT_EQ(share_nodes(s).points[0], lowest);
    EXPECT_EQ(share_nodes(s).points.size(), 4U);
}

TEST(SharedMesh, HasOnePointAtAVertex) {
    const Specimen s = test::jittered_grid(5, 7, 0.1, 0.14, 0.2);
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.points.size(), 6U * 8U);
    std::set<std::array<double, 2>> places(mesh.points.begin(), mesh.points.end());
    EXPECT_EQ(places.size(), mesh.points.size());
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(mesh.points[static_cast<std::size_t>(mesh.triangles[e][k])],
                      s.node_position[static_cast<std::size_t>(s.element_nodes[e][k])]);
        }
    }
    std::int32_t next = 0;  // every point appears before those of a higher number
    for (const auto& corners : mesh.triangles) {
        for (const std::int32_t point : corners) {
            EXPECT_LE(point, next);
            next = std::max(next, point + 1);
        }
    }
}

TEST(SharedMesh, KeepsApartTheSidesOfACutThatIsNoContact) {
    Specimen s = test::one_diagonal_grid(2, 1, 0.2, 0.1);
    test::cut_contacts(s, [](double x, double) { return std::abs(x) < 1e-9; });
    EXPECT_EQ(share_nodes(s).points.size(), 6U + 2U);  // the middle twice, at both ends
}

TEST(SharedMesh, KeepsOrderAndDirectionOfTheBoundary) {
    Specimen s = test::one_diagonal_grid(3, 2, 0.3, 0.2);
    test::name_boundary(s, "seat", [](double x, double y) { return x > 0 && y < -0.09; });
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.side_names, (std::vector<std::string>{"bottom", "right", "top", "left", "seat"}));
    ASSERT_EQ(mesh.sides.size(), s.n_boundary_edges());
    for (std::size_t b = 0; b < mesh.sides.size(); ++b) {
        EXPECT_EQ(mesh.side_names[mesh.sides[b].name], s.part_names[s.boundary_part[b]]);
        expect_at(mesh, mesh.sides[b], s, s.boundary_edges[b][0], s.boundary_edges[b][1]);
    }
}

TEST(SharedMesh, NamesCracksAndFlawsAsSides) {
    Specimen s = test::jittered_grid(3, 3, 0.3, 0.3, 0);
    ASSERT_GE(s.n_contacts(), 7U);
    s.flaw_names = {"vein", "joint"};
    s.contact_flaw.assign(s.n_contacts(), 0);
    s.contact_flaw[1] = 2;
    s.contact_flaw[2] = 1;
    s.contact_flaw[4] = 2;
    s.contact_kind[3] = s.contact_kind[4] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
    s.contact_kind[5] = static_cast<std::uint8_t>(ContactKind::open_boundary);
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.side_names, (std::vector<std::string>{"bottom", "right", "top", "left", "open-boundary", "crack", "flaw-vein",
                                                         "flaw-joint", "flaw-joint-broken"}));
    ASSERT_EQ(mesh.sides.size(), s.n_boundary_edges() + 5);
    const std::array<const char*, 5> names{"flaw-joint", "flaw-vein", "crack", "flaw-joint-broken", "open-boundary"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const NamedSide& side = mesh.sides[s.n_boundary_edges() + i];
        EXPECT_EQ(mesh.side_names[side.name], names[i]);
        expect_at(mesh, side, s, s.contact_nodes[i + 1][0], s.contact_nodes[i + 1][1]);
    }
}

TEST(SharedMesh, HasOneNameForCracksAndAPartThatIsCalledCrack) {
    Specimen s = test::one_diagonal_grid(2, 2, 0.2, 0.2);
    test::name_boundary(s, "crack", [](double, double y) { return y < -0.09; });
    test::break_contacts(s, [](double, double y) { return std::abs(y) < 1e-9; });
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.side_names, (std::vector<std::string>{"right", "top", "left", "crack"}));
    EXPECT_EQ(std::count_if(mesh.sides.begin(), mesh.sides.end(), [](const NamedSide& side) { return side.name == 3; }), 4);
}

}  // namespace
}  // namespace graincrack
