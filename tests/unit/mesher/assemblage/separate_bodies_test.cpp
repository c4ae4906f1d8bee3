#include "mesher/assemblage/separate_bodies.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "mesher/elements/divided_cells.hpp"
#include "share/file/specimen.hpp"
#include "tests/unit/mesher/cells/made_cells.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

/// A unit square of two triangles.
PlaneCells two_cells() {
    return cells_of({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, {{0, 1, 2}, {2, 3, 0}},
                    {{0, 1, 0}, {1, 2, 1}, {2, 3, 2}, {3, 0, 3}});
}

/// What a specimen needs beside its arrays.
Specimen specimen_of(const PlaneMesh& mesh) {
    Specimen s = separate_bodies(mesh);
    s.shape = "polygon";
    s.width = s.height = 1;
    s.tessellation = "delaunay";
    return s;
}

Request small_rectangle(int elements_per_edge) {
    return {.region = rectangle(0.04, 0.06), .fabric = {.grains = 200, .elements_per_edge = elements_per_edge}};
}

TEST(SeparateBodies, MakesOneContactBetweenTwoGrains) {
    const Specimen s = specimen_of(lattice_mesh(two_cells(), 1));
    validate(s, "two grains");
    ASSERT_EQ(s.n_grains(), 2U);
    ASSERT_EQ(s.n_nodes(), 6U);
    ASSERT_EQ(s.n_contacts(), 1U);
    EXPECT_EQ(s.n_boundary_edges(), 4U);
    EXPECT_DOUBLE_EQ(s.grain_area[0], 0.5);
}

TEST(SeparateBodies, MakesConformingContactsInOrder) {
    for (const int n : {1, 2, 3}) {
        const Specimen s = valid_mesh(small_rectangle(n));
        const auto grains = grain_of_nodes(s);
        std::set<std::array<int, 2>> pairs;
        for (std::size_t c = 0; c < s.n_contacts(); ++c) {
            const auto& [a1, a2, b1, b2] = s.contact_nodes[c];
            // positions on both sides are equal bit for bit
            EXPECT_EQ(s.node_position[index(a1)], s.node_position[index(b1)]);
            EXPECT_EQ(s.node_position[index(a2)], s.node_position[index(b2)]);
            const std::array<int, 2> pair{grains[index(a1)], grains[index(b1)]};
            EXPECT_LT(pair[0], pair[1]);
            EXPECT_EQ(s.contact_grain_boundary[c], static_cast<int>(c) / n);
            if (c % static_cast<std::size_t>(n) == 0) {
                EXPECT_TRUE(pairs.empty() || *pairs.rbegin() < pair) << "contacts are ordered by their grains";
                pairs.insert(pair);
            } else {
                EXPECT_TRUE(pairs.count(pair) == 1) << "contacts of one grain boundary lie together";
                EXPECT_EQ(a1, s.contact_nodes[c - 1][1]);
            }
        }
    }
}

TEST(SeparateBodies, ClosesTheBoundaryWithTheSolidOnItsLeft) {
    const Specimen s = mesh(small_rectangle(2));
    double doubled_area = 0;
    for (std::size_t b = 0; b < s.n_boundary_edges(); ++b) {
        const Point begin = place_of(s, s.boundary_edges[b][0]);
        const Point end = place_of(s, s.boundary_edges[b][1]);
        EXPECT_EQ(end, place_of(s, s.boundary_edges[(b + 1) % s.n_boundary_edges()][0])) << b;
        doubled_area += cross(begin, end);
        const std::array<double, 4> beyond{begin.y + 0.03, begin.x - 0.02, begin.y - 0.03, begin.x + 0.02};
        EXPECT_EQ(beyond.at(s.boundary_part[b]), 0) << b;
    }
    EXPECT_NEAR(doubled_area / 2, 0.04 * 0.06, 1e-15) << "counter-clockwise";
}

TEST(SeparateBodies, OrdersGrainsInSpace) {
    Request request = small_rectangle(1);
    request.fabric.grains = 2000;
    const Specimen s = mesh(request);
    double mean_step = 0;
    for (std::size_t g = 1; g < s.n_grains(); ++g) {
        const auto centre = [&](std::size_t grain) {
            Point sum;
            for (std::size_t k = 0; k < 3; ++k) sum = sum + place_of(s, static_cast<std::int32_t>(3 * grain + k));
            return (1.0 / 3) * sum;
        };
        mean_step += length(centre(g) - centre(g - 1)) / static_cast<double>(s.n_grains() - 1);
        const auto first = static_cast<std::int32_t>(3 * g);
        EXPECT_EQ(s.element_nodes[g], (std::array{first, first + 1, first + 2}));
    }
    EXPECT_LT(mean_step, 1.5 * s.statistics.mean_edge);
}

/// A square of two L-shaped cells, with a corner in the middle of an edge. The first corner of each sees all others.
PlaneCells two_polygons() {
    return cells_of(
        {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {0, 0.5}, {0, 0}, {0.25, 0}, {0.25, -0.5}},
        {{5, 4, 3, 0, 7, 6}, {6, 7, 1, 2, 4, 5}},
        {{0, 7, 0}, {7, 1, 0}, {1, 2, 1}, {2, 4, 2}, {4, 3, 2}, {3, 0, 3}, {5, 6, -1, ContactKind::pre_existing_crack}});
}

/// Triangles between the first corner of each cell and its sides.
PlaneMesh fans_of(PlaneCells cells, Bodies bodies) {
    PlaneMesh mesh;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const auto loop = cells.loop(cell);
        for (std::size_t i = 2; i < loop.size(); ++i) {
            if (bodies == Bodies::triangles || i == 2) mesh.crystal_of_body.push_back(static_cast<int>(cell));
            mesh.triangles.push_back({loop[0], loop[i - 1], loop[i]});
            mesh.body_of_triangle.push_back(static_cast<int>(mesh.n_bodies()) - 1);
        }
    }
    mesh.points = std::move(cells.points);
    mesh.sides = std::move(cells.sides);
    mesh.complete_bodies();
    return mesh;
}

TEST(SeparateBodies, MakesOneBoundaryOfSeveralContactsBetweenPolygons) {
    const Specimen s = specimen_of(fans_of(two_polygons(), Bodies::cells));
    validate(s, "two polygons");
    EXPECT_EQ(s.n_grains(), 2U);
    EXPECT_EQ(s.n_nodes(), 12U);
    ASSERT_EQ(s.contact_grain_boundary, (std::vector<std::int32_t>{0, 0, 0}));
    for (std::size_t c = 0; c < 3; ++c) {
        if (c > 0) {
            EXPECT_EQ(s.contact_nodes[c][0], s.contact_nodes[c - 1][1]);
        }
        // As only the prescribed edge is.
        const bool is_horizontal = place_of(s, s.contact_nodes[c][0]).y == place_of(s, s.contact_nodes[c][1]).y;
        EXPECT_EQ(s.contact_kind[c], is_horizontal ? 1 : 0);
    }
    EXPECT_EQ(s.boundary_part, (std::vector<std::uint8_t>{0, 0, 1, 2, 2, 3}));
    EXPECT_DOUBLE_EQ(s.grain_area[0] + s.grain_area[1], 1);
}

TEST(SeparateBodies, MakesContactsInsideCrystalsOfSeveralBodies) {
    const PlaneMesh mesh = fans_of(two_polygons(), Bodies::triangles);
    const Specimen s = specimen_of(mesh);
    validate(s, "triangles");
    EXPECT_EQ(s.n_grains(), 8U);
    EXPECT_EQ(s.n_contacts(), 3U + 2 * 3U) << "three between the crystals and three inside each";
    EXPECT_EQ(mesh.crystal_of_body, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(SeparateBodies, RefusesAMeshThatDoesNotFollowItsRegion) {
    PlaneCells missing = two_cells();
    missing.sides[0] = {1, 3, 0};
    EXPECT_THROW(separate_bodies(lattice_mesh(missing, 1)), Error);
    PlaneCells open = two_cells();
    open.sides.pop_back();
    EXPECT_THROW(separate_bodies(lattice_mesh(open, 1)), Error);
}

}  // namespace
}  // namespace graincrack::mesher
