#include "post/export/mesh_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

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

TEST(MeshFile, GmshTextIsMsh2) {
    EXPECT_EQ(
        gmsh_text(two_grains()),
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
        "$PhysicalNames\n7\n2 1 \"quartz\"\n2 2 \"mica\"\n1 3 \"right\"\n1 4 \"top\"\n1 5 \"left\"\n1 6 \"rim\"\n1 7 \"crack\"\n"
        "$EndPhysicalNames\n"
        "$Nodes\n5\n1 -0.1 0 0\n2 0.1 0 0\n3 0.1 0.1 0\n4 -0.1 0.1 0\n5 0 -0.1 0\n$EndNodes\n"
        "$Elements\n9\n"
        "1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n3 2 2 2 2 5 2 1\n"                                         // grains
        "4 1 2 5 5 4 1\n5 1 2 6 6 1 5\n6 1 2 3 3 2 3\n7 1 2 6 6 5 2\n8 1 2 4 4 3 4\n9 1 2 7 7 1 2\n"  // sides
        "$EndElements\n");
}

/// The words of the lines behind a line, up to the next that begins with a sign.
std::vector<std::vector<std::string>> rows_behind(const std::string& text, const std::string& head) {
    std::istringstream lines(text.substr(std::min(text.size(), text.find(head + "\n"))));
    std::vector<std::vector<std::string>> rows;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && line[0] != '$') {
        std::istringstream words(line);
        rows.emplace_back(std::istream_iterator<std::string>(words), std::istream_iterator<std::string>());
    }
    return rows;
}

TEST(MeshFile, CoordinatesReadBackExactly) {
    Specimen s = test::jittered_grid(9, 9, 0.1 / 3, std::numbers::pi / 100, 0.2);
    s.node_position[0][0] = -0.0;
    s.node_position[1][1] = 5e-324;
    const SharedMesh mesh = share_nodes(s);
    auto gmsh = rows_behind(gmsh_text(mesh), "$Nodes");
    gmsh.erase(gmsh.begin());  // their number
    ASSERT_EQ(gmsh.size(), mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        EXPECT_EQ(gmsh[i][0], std::to_string(i + 1));
        for (std::size_t axis = 0; axis < 2; ++axis) {
            double value = 1;
            const std::string& digits = gmsh[i][axis + 1];
            EXPECT_EQ(std::from_chars(digits.data(), digits.data() + digits.size(), value).ptr, digits.data() + digits.size());
            EXPECT_EQ(value, mesh.points[i][axis]);
            EXPECT_EQ(std::signbit(value), std::signbit(mesh.points[i][axis]));
        }
    }
}

TEST(MeshFile, LossesAreWhatAFormatDoesNotCarry) {
    SharedMesh mesh = two_grains();
    EXPECT_TRUE(losses(mesh).empty());
    mesh.has_strength_factors = true;
    mesh.phase_names = {"Feldspat, weiß", "brown \"mica\"\n"};
    EXPECT_EQ(losses(mesh),
              (std::vector<std::string>{
                  "leaves out strength factors of contacts (import --seed 0 draws them again with their modulus or material)",
                  "has brown 'mica'\\x0a for the name brown \"mica\"\\x0a"}));
    EXPECT_NE(gmsh_text(mesh).find("2 1 \"Feldspat, weiß\"\n2 2 \"brown 'mica'\\x0a\"\n"), std::string::npos);
}

TEST(MeshFile, CrystalsOfSeveralGrainsAreEntities) {
    Specimen s = test::one_diagonal_grid(2, 1, 0.2, 0.1);
    s.grain_crystal = {0, 0, 1, 1};
    s.flaw_names = {"within_rock"};
    s.contact_flaw.assign(s.n_contacts(), 0);
    s.contact_flaw[0] = 1;
    s.contact_kind[0] = static_cast<std::uint8_t>(ContactKind::within_crystal);
    const SharedMesh mesh = share_nodes(s);
    EXPECT_TRUE(losses(mesh).empty());
    EXPECT_EQ(mesh.sides.size(), s.n_boundary_edges()) << "contacts within crystals follow from the crystals";
    const auto elements = rows_behind(gmsh_text(mesh), "$Elements");
    for (std::size_t t = 0; t < 4; ++t) EXPECT_EQ(elements[t + 1][4], t < 2 ? "1" : "2");
    s.element_grain = {0, 0, 1, 1};
    s.grain_phase.resize(2);
    s.grain_crystal = {0, 0};
    EXPECT_EQ(losses(share_nodes(s)), std::vector<std::string>{"leaves out grains of several elements within crystals"});
}

/// Two triangles side by side, split by a diagonal: six nodes at four places.
Specimen square() { return test::one_diagonal_grid(1, 1, 0.2, 0.1); }

TEST(SharedMesh, APointLiesWhereItsLowestNodeDoes) {
    Specimen s = square();
    const auto lowest = s.node_position[0];
    s.node_position[3][0] += 1e-12;  // of the other grain, within what a contact may be off
    EXPECT_EQ(share_nodes(s).points[0], lowest);
    EXPECT_EQ(share_nodes(s).points.size(), 4U);
}

TEST(SharedMesh, PointsAroundAVertexAreOne) {
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

TEST(SharedMesh, SidesOfACutThatIsNoContactStayApart) {
    Specimen s = test::one_diagonal_grid(2, 1, 0.2, 0.1);
    test::cut_contacts(s, [](double x, double) { return std::abs(x) < 1e-9; });
    EXPECT_EQ(share_nodes(s).points.size(), 6U + 2U);  // the middle twice, at both ends
}

TEST(SharedMesh, BoundaryKeepsItsOrderAndDirection) {
    Specimen s = test::one_diagonal_grid(3, 2, 0.3, 0.2);
    test::name_boundary(s, "seat", [](double x, double y) { return x > 0 && y < -0.09; });
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.side_names, (std::vector<std::string>{"bottom", "right", "top", "left", "seat"}));
    ASSERT_EQ(mesh.sides.size(), s.n_boundary_edges());
    for (std::size_t b = 0; b < mesh.sides.size(); ++b) {
        EXPECT_EQ(mesh.side_names[mesh.sides[b].name], s.part_names[s.boundary_part[b]]);
        EXPECT_EQ(mesh.points[static_cast<std::size_t>(mesh.sides[b].from)],
                  s.node_position[static_cast<std::size_t>(s.boundary_edges[b][0])]);
        EXPECT_EQ(mesh.points[static_cast<std::size_t>(mesh.sides[b].to)],
                  s.node_position[static_cast<std::size_t>(s.boundary_edges[b][1])]);
    }
}

TEST(SharedMesh, CracksAndFlawsAreSidesWithNames) {
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
        const auto& nodes = s.contact_nodes[i + 1];
        EXPECT_EQ(mesh.points[static_cast<std::size_t>(side.from)], s.node_position[static_cast<std::size_t>(nodes[0])]);
        EXPECT_EQ(mesh.points[static_cast<std::size_t>(side.to)], s.node_position[static_cast<std::size_t>(nodes[1])]);
    }
}

TEST(SharedMesh, APartThatIsCalledCrackAndCracksHaveOneName) {
    Specimen s = test::one_diagonal_grid(2, 2, 0.2, 0.2);
    test::name_boundary(s, "crack", [](double, double y) { return y < -0.09; });
    test::break_contacts(s, [](double, double y) { return std::abs(y) < 1e-9; });
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.side_names, (std::vector<std::string>{"right", "top", "left", "crack"}));
    EXPECT_EQ(std::count_if(mesh.sides.begin(), mesh.sides.end(), [](const NamedSide& side) { return side.name == 3; }), 4);
}

}  // namespace
}  // namespace graincrack
