#include "mesher/region/fit_edges.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mesher/region/shapes.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden.hpp"

namespace graincrack::mesher {
namespace {

constexpr double edge = 4e-3;

Region with_edges(std::vector<PrescribedEdge> edges) {
    Region region = rectangle(0.08, 0.08);
    region.edges = std::move(edges);
    return region;
}

PrescribedEdge flaw(Point from, Point to, const std::string& name = "flaw", bool needed = true) {
    return {from, to, ContactKind::pre_existing_crack, name, needed};
}

std::vector<PrescribedEdge> fitted(std::vector<PrescribedEdge> edges) { return fitted_edges(with_edges(std::move(edges)), edge); }

TEST(FitEdges, MovesEndsThatAlmostMeetAlongTheirLine) {
    const auto edges = fitted({flaw({-0.02, -0.01}, {0.039, 0.02}), flaw({0, 0.03}, {0, 0.0005})});
    ASSERT_EQ(edges.size(), 2U);
    EXPECT_EQ(edges[0].from, (Point{-0.02, -0.01}));
    EXPECT_NEAR(edges[0].to.x, 0.04, 1e-15) << "extended to the boundary";
    EXPECT_NEAR(cross(edges[0].to - edges[0].from, Point{0.059, 0.03}), 0, 1e-17) << "on its line";
    EXPECT_EQ(edges[1].to.x, 0);
    EXPECT_NEAR(edges[1].to.y, -0.01 + 0.02 * 0.03 / 0.059, 1e-15) << "extended to the other flaw";
    const auto longer = fitted({flaw({-0.03, 0}, {0.03, 0}), flaw({0, 0.03}, {0, -0.0005})});
    EXPECT_NEAR(longer[1].to.y, 0, 1e-15) << "shortened to the other flaw";
    const auto first = fitted({flaw({0, 0.03}, {0, -0.0005}), flaw({-0.03, 0}, {0.03, 0})});
    EXPECT_NEAR(first[0].to.y, 0, 1e-15) << "also if the other comes later";
}

// Of edges of 4 mm: more than .4 mm is told, more than 1.4 mm is refused, where an end lies nearer than 1.4 mm to what it meets.
TEST(FitEdges, TellsOrRefusesToMoveEnds) {
    std::vector<std::string> moves;
    const auto fit = [&](double x, bool needed) {
        (void)fitted_edges(with_edges({flaw({0, 0}, {x, 0.01}, "a", needed)}), edge, &moves);
    };
    fit(0.0397, true);
    fit(0.039, false);
    EXPECT_TRUE(moves.empty()) << "by less, or of joints, which are drawn at random";
    fit(0.039, true);
    ASSERT_EQ(moves.size(), 1U);
    test::expect_golden(moves[0]);
    const PrescribedEdge a = flaw({-0.03, 0}, {0.03, 0}, "a");
    test::Refusals refused;
    refused.add<UsageError>("oblique", [&] { fitted({a, flaw({-0.02, 0.012}, {0.0145, 0.0013}, "b")}); });
    test::expect_golden(refused.text(), "refused");
    EXPECT_NO_THROW(fitted({a, flaw({-0.02, 0.012}, {0.0145, 0.0013}, "b", false)}));
}

TEST(FitEdges, ClipsToTheRegion) {
    Region region = with_edges({flaw({-0.1, 0.02}, {0.1, 0.02})});
    add_hole(region, {0, 0.02}, 0.01, "--hole");
    const auto edges = fitted_edges(region, edge);
    ASSERT_EQ(edges.size(), 2U);
    EXPECT_NEAR(edges[0].from.x, -0.04, 1e-15);
    EXPECT_NEAR(edges[0].to.x, -0.01, 1e-15);
    EXPECT_NEAR(edges[1].to.x, 0.04, 1e-15);
}

TEST(FitEdges, RefusesWhatMakesSlivers) {
    const PrescribedEdge a = flaw({-0.02, 0}, {0.02, 0}, "a");
    test::Refusals refused;
    const auto add = [&](const std::string& what, Point from, Point to) {
        refused.add<UsageError>(what, [&] { fitted({a, flaw(from, to, "b")}); });
    };
    add("1 mm beside", {-0.02, 0.001}, {0.02, 0.001});
    add("upon", {0, 0}, {0.03, 0});
    add("oblique", {-0.03, -0.002}, {0.03, 0.002});
    add("outside", {0.05, 0}, {0.07, 0});
    add("beside the boundary", {-0.03, 0.0395}, {0.03, 0.0395});
    add("short", {0, 0.02}, {0.001, 0.02});
    add("beside the boundary and out", {0.0395, 0.03}, {0.0395, 0.05});
    const PrescribedEdge c = flaw({0, -0.02}, {0, 0.02}, "c");
    refused.add<UsageError>("near a crossing", [&] { fitted({a, c, flaw({-0.0192, -0.02}, {0.0208, 0.02}, "b")}); });
    test::expect_golden(refused.text());
    EXPECT_NO_THROW(fitted({a, flaw({0.02, 0}, {0.03, 0}, "b")})) << "one continues the other";
    EXPECT_NO_THROW(fitted({a, flaw({-0.02, 0.002}, {0.02, 0.002})})) << "2 mm beside";
}

TEST(FitEdges, LeavesThePolesOfADiscInTheirPlaces) {
    const auto fits = [](double from_pole) {
        Region region = disc(0.08);
        region.edges = {flaw({0, 0}, {from_pole, 0.05})};
        try {
            return fitted_edges(region, edge).size() == 1;
        } catch (const UsageError&) {
            return false;
        }
    };
    EXPECT_TRUE(fits(0)) << "the middle of the facet";
    EXPECT_FALSE(fits(0.002 * 5 / 4 + 0.0004)) << "beside an end of the facet";
    EXPECT_TRUE(fits(0.005));
}

TEST(FitEdges, LeavesOutWhatIsNotNeeded) {
    const auto edges = fitted({flaw({-0.02, 0.001}, {0.02, 0.001}, "b", false), flaw({-0.02, 0}, {0.02, 0})});
    ASSERT_EQ(edges.size(), 1U) << "what is needed comes first";
    EXPECT_EQ(edges[0].from.y, 0);
}

}  // namespace
}  // namespace graincrack::mesher
