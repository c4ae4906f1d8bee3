#include "post/export/mesh_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/specimens.hpp"

namespace graincrack {
namespace {

/// Two triangles side by side, split by a diagonal: six nodes at four places.
Specimen square() { return test::one_diagonal_grid(1, 1, 0.2, 0.1); }

TEST(SharedMesh, HasEachPointOnceInTheOrderOfItsLowestNode) {
    const Specimen s = square();
    ASSERT_EQ(s.n_nodes(), 6U);
    const SharedMesh mesh = share_nodes(s);
    ASSERT_EQ(mesh.points.size(), 4U);
    // The nodes of the first grain are its own; of the second, one is.
    for (std::size_t node = 0; node < 3; ++node) EXPECT_EQ(mesh.points[node], s.node_position[node]);
    EXPECT_EQ(mesh.points[3], s.node_position[5]);
    ASSERT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.triangles[0], (std::array<std::int32_t, 3>{0, 1, 2}));
    EXPECT_EQ(mesh.triangles[1], (std::array<std::int32_t, 3>{0, 2, 3}));
}

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

TEST(SharedMesh, GrainsOfSeveralElementsKeepThem) {
    const Specimen s = test::crossed_blocks(4, 4, 0.1, 0.1, [](int i, int j) { return j / 2 * 2 + i / 2; });
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.points.size(), 25U + 16U);
    EXPECT_EQ(mesh.triangles.size(), 64U);
    EXPECT_EQ(mesh.triangle_grain, s.element_grain);
    EXPECT_EQ(std::count(mesh.triangle_grain.begin(), mesh.triangle_grain.end(), 3), 16);
    EXPECT_EQ(mesh.grain_area, s.grain_area);
    EXPECT_EQ(mesh.sides.size(), s.n_boundary_edges());  // grain boundaries have no name
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
    ASSERT_GE(s.n_contacts(), 6U);
    s.flaw_names = {"vein", "joint"};
    s.contact_flaw.assign(s.n_contacts(), 0);
    s.contact_flaw[1] = 2;
    s.contact_flaw[2] = 1;
    s.contact_flaw[4] = 2;
    s.contact_kind[3] = s.contact_kind[4] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.side_names, (std::vector<std::string>{"bottom", "right", "top", "left", "crack", "flaw-vein", "flaw-joint",
                                                         "flaw-joint-broken"}));
    ASSERT_EQ(mesh.sides.size(), s.n_boundary_edges() + 4);
    const std::array<const char*, 4> names{"flaw-joint", "flaw-vein", "crack", "flaw-joint-broken"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const NamedSide& side = mesh.sides[s.n_boundary_edges() + i];
        EXPECT_EQ(mesh.side_names[side.name], names[i]);
        const auto& nodes = s.contact_nodes[i + 1];
        EXPECT_EQ(mesh.points[static_cast<std::size_t>(side.from)], s.node_position[static_cast<std::size_t>(nodes[0])]);
        EXPECT_EQ(mesh.points[static_cast<std::size_t>(side.to)], s.node_position[static_cast<std::size_t>(nodes[1])]);
    }
}

TEST(SharedMesh, OpenBoundariesHaveANameOfTheirOwn) {
    Specimen s = test::one_diagonal_grid(2, 2, 0.2, 0.2);
    s.contact_kind[0] = static_cast<std::uint8_t>(ContactKind::open_boundary);
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.side_names, (std::vector<std::string>{"bottom", "right", "top", "left", "open-boundary"}));
    EXPECT_EQ(mesh.sides.size(), s.n_boundary_edges() + 1);
}

TEST(SharedMesh, APartThatIsCalledCrackAndCracksHaveOneName) {
    Specimen s = test::one_diagonal_grid(2, 2, 0.2, 0.2);
    test::name_boundary(s, "crack", [](double, double y) { return y < -0.09; });
    test::break_contacts(s, [](double, double y) { return std::abs(y) < 1e-9; });
    const SharedMesh mesh = share_nodes(s);
    EXPECT_EQ(mesh.side_names, (std::vector<std::string>{"right", "top", "left", "crack"}));
    EXPECT_EQ(std::count_if(mesh.sides.begin(), mesh.sides.end(), [](const NamedSide& side) { return side.name == 3; }), 4);
}

TEST(SharedMesh, SaysWhetherContactsHaveStrengthFactors) {
    Specimen s = square();
    EXPECT_FALSE(share_nodes(s).has_strength_factors);
    s.contact_strength_factor.assign(s.n_contacts(), 1.1);
    EXPECT_TRUE(share_nodes(s).has_strength_factors);
}

}  // namespace
}  // namespace graincrack
