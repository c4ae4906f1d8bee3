#include "mesher/region/fit_edges.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mesher/region/shapes.hpp"
#include "share/base/error.hpp"

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

std::string complaint_about_edges(std::vector<PrescribedEdge> edges) {
    try {
        (void)fitted_edges(with_edges(std::move(edges)), edge);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(FitEdges, EndsThatAlmostMeetAreMovedAlongTheirLine) {
    const auto edges = fitted_edges(with_edges({flaw({-0.02, -0.01}, {0.039, 0.02}), flaw({0, 0.03}, {0, 0.0005})}), edge);
    ASSERT_EQ(edges.size(), 2U);
    EXPECT_EQ(edges[0].from, (Point{-0.02, -0.01}));
    EXPECT_NEAR(edges[0].to.x, 0.04, 1e-15) << "extended to the boundary";
    EXPECT_NEAR(cross(edges[0].to - edges[0].from, Point{0.059, 0.03}), 0, 1e-17) << "on its line";
    EXPECT_EQ(edges[1].to.x, 0);
    EXPECT_NEAR(edges[1].to.y, -0.01 + 0.02 * 0.03 / 0.059, 1e-15) << "extended to the other flaw";
    const auto longer = fitted_edges(with_edges({flaw({-0.03, 0}, {0.03, 0}), flaw({0, 0.03}, {0, -0.0005})}), edge);
    EXPECT_NEAR(longer[1].to.y, 0, 1e-15) << "shortened to the other flaw";
    const auto first = fitted_edges(with_edges({flaw({0, 0.03}, {0, -0.0005}), flaw({-0.03, 0}, {0.03, 0})}), edge);
    EXPECT_NEAR(first[0].to.y, 0, 1e-15) << "also if the other comes later";
}

// Of edges of 4 mm: more than .4 mm is told, more than 1.4 mm is refused, where an end lies nearer than 1.4 mm to what it meets.
TEST(FitEdges, EndsThatMoveAreToldOrRefused) {
    std::vector<std::string> moves;
    const auto told = [&](double x, bool needed) {
        Region region = with_edges({flaw({0, 0}, {x, 0.01}, "a", needed)});
        (void)fitted_edges(region, edge, &moves);
        return moves;
    };
    EXPECT_EQ(told(0.0397, true), std::vector<std::string>());
    EXPECT_EQ(
        told(0.039, true),
        std::vector<std::string>{"a: an end was moved by 1.032 mm to what it almost met; its length is 41.29 mm, not 40.26 mm"});
    EXPECT_EQ(told(0.039, false), std::vector<std::string>()) << "joints are drawn at random";
    const std::vector<PrescribedEdge> oblique{flaw({-0.03, 0}, {0.03, 0}, "a"), flaw({-0.02, 0.012}, {0.0145, 0.0013}, "b")};
    EXPECT_EQ(complaint_about_edges(oblique),
              "b: an end would move by 4.389 mm to what it almost meets; end it there or 1.4 mm away");
    EXPECT_EQ(complaint_about_edges({oblique[0], flaw(oblique[1].from, oblique[1].to, "b", false)}), "");
}

TEST(FitEdges, PiecesAreClipped) {
    Region region = with_edges({flaw({-0.1, 0.02}, {0.1, 0.02})});
    add_hole(region, {0, 0.02}, 0.01, "--hole");
    const auto edges = fitted_edges(region, edge);
    ASSERT_EQ(edges.size(), 2U);
    EXPECT_NEAR(edges[0].from.x, -0.04, 1e-15);
    EXPECT_NEAR(edges[0].to.x, -0.01, 1e-15);
    EXPECT_NEAR(edges[1].to.x, 0.04, 1e-15);
}

TEST(FitEdges, WhatMakesSliversIsRefusedByName) {
    EXPECT_EQ(complaint_about_edges({flaw({-0.02, 0}, {0.02, 0}), flaw({-0.02, 0.002}, {0.02, 0.002})}), "");
    const auto names = [](const std::string& message, const std::string& words) {
        EXPECT_NE(message.find("b: "), std::string::npos) << message;
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    const PrescribedEdge a = flaw({-0.02, 0}, {0.02, 0}, "a");
    names(complaint_about_edges({a, flaw({-0.02, 0.001}, {0.02, 0.001}, "b")}), "comes within 1 mm of a");
    names(complaint_about_edges({a, flaw({0, 0}, {0.03, 0}, "b")}), "lies upon a");
    names(complaint_about_edges({a, flaw({-0.03, -0.002}, {0.03, 0.002}, "b")}), "meets a under 3.81 deg");
    names(complaint_about_edges({a, flaw({0.05, 0}, {0.07, 0}, "b")}), "outside");
    names(complaint_about_edges({a, flaw({-0.03, 0.0395}, {0.03, 0.0395}, "b")}), "beside the boundary");
    names(complaint_about_edges({a, flaw({0, 0.02}, {0.001, 0.02}, "b")}), "less than half a grain edge");
    names(complaint_about_edges({a, flaw({0.0395, 0.03}, {0.0395, 0.05}, "b")}), "");
    names(complaint_about_edges({a, flaw({0, -0.02}, {0, 0.02}, "c"), flaw({-0.0192, -0.02}, {0.0208, 0.02}, "b")}), "crosses");
    EXPECT_EQ(complaint_about_edges({a, flaw({0.02, 0}, {0.03, 0}, "b")}), "") << "one continues the other";
}

TEST(FitEdges, PolesOfADiscStayWhereTheyAre) {
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

TEST(FitEdges, WhatIsNotNeededIsLeftOutInstead) {
    const auto edges =
        fitted_edges(with_edges({flaw({-0.02, 0.001}, {0.02, 0.001}, "b", false), flaw({-0.02, 0}, {0.02, 0})}), edge);
    ASSERT_EQ(edges.size(), 1U) << "what is needed comes first";
    EXPECT_EQ(edges[0].from.y, 0);
}

}  // namespace
}  // namespace graincrack::mesher
