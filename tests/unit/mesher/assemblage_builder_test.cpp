#include "mesher/assemblage_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mesher/mesh_statistics.hpp"
#include "mesher/specimen_maker.hpp"
#include "share/error.hpp"

namespace graincrack::mesher {
namespace {

using Place = std::array<double, 2>;

/// A unit square of two grains.
struct TwoGrains {
    Shape shape{ShapeKind::rectangle, 1, 1, Pole::facet};
    Outline outline;
    PlaneMesh mesh;
    TwoGrains() {
        outline.points = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
        outline.parts = {BoundaryPart::bottom, BoundaryPart::right, BoundaryPart::top, BoundaryPart::left};
        mesh.points = outline.points;
        mesh.triangles = {{0, 1, 2}, {2, 3, 0}};
        mesh.edges = edges_of(mesh.triangles, 4);
    }
};

SpecimenRequest small_rectangle(int elements_per_edge) {
    SpecimenRequest request;
    request.shape = {ShapeKind::rectangle, 0.04, 0.06, Pole::facet};
    request.grains = 200;
    request.elements_per_edge = elements_per_edge;
    return request;
}

TEST(AssemblageBuilder, TwoGrainsShareOneContact) {
    const TwoGrains two;
    const Specimen s = build_assemblage(two.shape, two.outline, two.mesh, 1);
    validate(s, "two grains");
    ASSERT_EQ(s.n_grains(), 2U);
    ASSERT_EQ(s.n_nodes(), 6U);
    ASSERT_EQ(s.n_contacts(), 1U);
    EXPECT_EQ(s.n_boundary_edges(), 4U);
    EXPECT_EQ(s.contact_grain_boundary[0], 0);
    const auto [a1, a2, b1, b2] = s.contact_nodes[0];
    EXPECT_EQ(s.node_position[static_cast<std::size_t>(a1)], s.node_position[static_cast<std::size_t>(b1)]);
    EXPECT_EQ(s.node_position[static_cast<std::size_t>(a2)], s.node_position[static_cast<std::size_t>(b2)]);
    EXPECT_LT(a1, 3);
    EXPECT_GE(b1, 3);
    EXPECT_DOUBLE_EQ(s.grain_area[0], 0.5);
}

TEST(AssemblageBuilder, StatisticsOfTwoGrains) {
    const TwoGrains two;
    const MeshStatistics s = mesh_statistics(two.shape, two.mesh);
    const double mean = (4 + std::sqrt(2)) / 5;
    EXPECT_NEAR(s.mean_edge, mean, 1e-15);
    EXPECT_NEAR(s.edge_variation, std::sqrt(6.0 / 5 - mean * mean) / mean, 1e-12);
    EXPECT_DOUBLE_EQ(s.min_edge, 1);
    EXPECT_DOUBLE_EQ(s.max_edge, std::sqrt(2));
    EXPECT_NEAR(s.mean_diameter, std::sqrt(2 / 3.14159265358979), 1e-12);
    EXPECT_NEAR(s.diameter_variation, 0, 1e-12);
    EXPECT_NEAR(s.min_angle, 3.14159265358979 / 4, 1e-12);
    EXPECT_NEAR(s.psi6, 1.0 / 5, 1e-12);  // the sides cancel, the diagonal has e^(i 270°)
    EXPECT_NEAR(s.area_error, 0, 1e-15);
}

TEST(AssemblageBuilder, CountsAreThoseOfTheArrays) {
    for (const int n : {1, 2, 3}) {
        const Specimen s = make_specimen(small_rectangle(n));
        const auto boundary = static_cast<std::int64_t>(s.n_boundary_edges()) / n;
        const AssemblageCounts counts = assemblage_counts(200, boundary, n);
        EXPECT_EQ(static_cast<std::int64_t>(s.n_nodes()), counts.nodes) << n;
        EXPECT_EQ(static_cast<std::int64_t>(s.n_elements()), counts.elements) << n;
        EXPECT_EQ(static_cast<std::int64_t>(s.n_contacts()), counts.contacts) << n;
        EXPECT_EQ(s.grain_area.size(), 200U) << n;
    }
}

TEST(AssemblageBuilder, ContactsAreConformingAndOrdered) {
    for (const int n : {1, 2, 3}) {
        const Specimen s = make_specimen(small_rectangle(n));
        validate(s, "rectangle");
        const auto grains = grain_of_nodes(s);
        std::set<std::array<int, 2>> pairs;
        for (std::size_t c = 0; c < s.n_contacts(); ++c) {
            const auto& [a1, a2, b1, b2] = s.contact_nodes[c];
            // positions on both sides are equal bit for bit
            EXPECT_EQ(s.node_position[static_cast<std::size_t>(a1)], s.node_position[static_cast<std::size_t>(b1)]);
            EXPECT_EQ(s.node_position[static_cast<std::size_t>(a2)], s.node_position[static_cast<std::size_t>(b2)]);
            const std::array<int, 2> pair{grains[static_cast<std::size_t>(a1)], grains[static_cast<std::size_t>(b1)]};
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

/// Directed sides of elements that no other element of the same grain shares: the outer sides of the grains.
std::vector<std::array<std::int32_t, 2>> grain_outsides(const Specimen& s) {
    std::set<std::array<std::int32_t, 2>> sides;
    for (const auto& nodes : s.element_nodes) {
        for (std::size_t k = 0; k < 3; ++k) sides.insert({nodes[k], nodes[(k + 1) % 3]});
    }
    std::vector<std::array<std::int32_t, 2>> outsides;
    for (const auto& side : sides) {
        if (sides.count({side[1], side[0]}) == 0) outsides.push_back(side);
    }
    return outsides;
}

TEST(AssemblageBuilder, EveryOutsideIsInOneContactOrOnTheBoundary) {
    for (const int n : {1, 2, 3}) {
        const Specimen s = make_specimen(small_rectangle(n));
        std::map<std::array<std::int32_t, 2>, int> uses;
        for (const auto& [a1, a2, b1, b2] : s.contact_nodes) {
            ++uses[{a1, a2}];  // counter-clockwise around a …
            ++uses[{b2, b1}];  // … and around b
        }
        for (const auto& edge : s.boundary_edges) ++uses[edge];
        const auto outsides = grain_outsides(s);
        EXPECT_EQ(uses.size(), outsides.size()) << n;
        for (const auto& side : outsides) EXPECT_EQ(uses[side], 1) << n;
    }
}

TEST(AssemblageBuilder, BoundaryIsAClosedLoopWithTheSolidOnItsLeft) {
    const Specimen s = make_specimen(small_rectangle(2));
    const auto at = [&](std::int32_t node) { return s.node_position[static_cast<std::size_t>(node)]; };
    double doubled_area = 0;
    for (std::size_t b = 0; b < s.n_boundary_edges(); ++b) {
        const Place end = at(s.boundary_edges[b][1]);
        const Place next = at(s.boundary_edges[(b + 1) % s.n_boundary_edges()][0]);
        EXPECT_EQ(end, next) << b;
        const Place begin = at(s.boundary_edges[b][0]);
        doubled_area += begin[0] * end[1] - begin[1] * end[0];
        const auto part = static_cast<BoundaryPart>(s.boundary_part[b]);
        const double outward = part == BoundaryPart::bottom  ? -begin[1] - 0.03
                               : part == BoundaryPart::right ? begin[0] - 0.02
                               : part == BoundaryPart::top   ? begin[1] - 0.03
                                                             : -begin[0] - 0.02;
        EXPECT_EQ(outward, 0) << b;
    }
    EXPECT_NEAR(doubled_area / 2, 0.04 * 0.06, 1e-15) << "counter-clockwise";
}

TEST(AssemblageBuilder, GrainsFollowEachOtherInSpace) {
    SpecimenRequest request = small_rectangle(1);
    request.grains = 2000;
    const Specimen s = make_specimen(request);
    double mean_step = 0;
    for (std::size_t g = 1; g < s.n_grains(); ++g) {
        const auto centre = [&](std::size_t grain) {
            Point sum;
            for (std::size_t k = 0; k < 3; ++k) {
                const Place p = s.node_position[3 * grain + k];
                sum = sum + Point{p[0], p[1]};
            }
            return (1.0 / 3) * sum;
        };
        mean_step += length(centre(g) - centre(g - 1)) / static_cast<double>(s.n_grains() - 1);
        EXPECT_EQ(s.element_nodes[g],
                  (std::array<std::int32_t, 3>{static_cast<std::int32_t>(3 * g), static_cast<std::int32_t>(3 * g + 1),
                                               static_cast<std::int32_t>(3 * g + 2)}));
    }
    EXPECT_LT(mean_step, 1.5 * s.statistics.mean_edge);
}

TEST(AssemblageBuilder, SubdivisionKeepsAreas) {
    for (const int n : {2, 3, 5}) {
        const Specimen s = make_specimen(small_rectangle(n));
        std::vector<double> area(s.n_grains(), 0);
        for (std::size_t e = 0; e < s.n_elements(); ++e) {
            std::array<Point, 3> p;
            for (std::size_t k = 0; k < 3; ++k) {
                const Place place = s.node_position[static_cast<std::size_t>(s.element_nodes[e][k])];
                p[k] = {place[0], place[1]};
            }
            const double a = signed_area(p[0], p[1], p[2]);
            EXPECT_GT(a, 0);
            area[static_cast<std::size_t>(s.element_grain[e])] += a;
        }
        for (std::size_t g = 0; g < s.n_grains(); ++g) EXPECT_NEAR(area[g] / s.grain_area[g], 1, 1e-12);
    }
}

TEST(AssemblageBuilder, RefusesMoreNodesThanIndices) {
    const TwoGrains two;
    EXPECT_THROW(build_assemblage(two.shape, two.outline, two.mesh, 60000), UsageError);
}

}  // namespace
}  // namespace graincrack::mesher
