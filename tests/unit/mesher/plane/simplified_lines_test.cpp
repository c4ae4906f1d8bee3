#include "mesher/plane/simplified_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "share/base/error.hpp"

namespace graincrack::mesher {
namespace {

using Line = std::vector<Point>;

constexpr Clearance needed{0.5, 0.35};

/// What is left of a line that another lies around, far away.
Line simple(const DenseLine& line) {
    const DenseLine frame{{{-90, -90}, {90, -90}, {90, 90}, {-90, 90}, {-90, -90}}, 1, 1, 0, true};
    return simplified_lines(std::vector{line, frame}, needed).front();
}
/// The same of a line of some spacing and tolerance, without an area.
Line simple(const Line& points, double spacing, double tolerance) { return simple({points, spacing, tolerance, 0, false}); }

TEST(SimplifiedLines, HaveSegmentsOfAboutTheSpacingWithinTheTolerance) {
    Line straight;
    Line steps;
    for (int x = 0; x <= 60; ++x) {
        straight.push_back({1.0 * x, 0});
        steps.push_back({1.0 * x, std::round(0.2 * x)});
    }
    for (const double spacing : {4.0, 10.0, 20.0}) {
        EXPECT_NEAR(static_cast<double>(simple(straight, spacing, 1).size()) - 1, 60 / spacing, 0.3 * 60 / spacing);
    }
    EXPECT_EQ(simple(straight, 1000, 1), (Line{straight.front(), straight.back()}));
    EXPECT_EQ(simple(steps, 1000, 1), (Line{steps.front(), steps.back()}));
    EXPECT_GT(simple(steps, 1000, 0.1).size(), 20U);
}

TEST(SimplifiedLines, HaveTheAreasOfCircles) {
    for (const double radius : {2.0, 6.0, 20.0}) {
        DenseLine line{{}, radius, 0.3 * radius, 2 * std::numbers::pi * radius * radius, true};
        const int n = static_cast<int>(9 * radius);  // points 0.7 apart, as the middles of the sides of pixels
        for (int i = 0; i <= n; ++i) {
            const double angle = 2 * std::numbers::pi * (i % n) / n;
            line.points.push_back(radius * Point{std::cos(angle), std::sin(angle)});
        }
        const Line left = simple(line);
        EXPECT_EQ(left.front(), left.back());
        EXPECT_LT(left.size(), 10U);
        double sum = 0;
        for (std::size_t i = 1; i < left.size(); ++i) sum += cross(left[i - 1], left[i]);
        EXPECT_NEAR(sum / line.doubled_area, 1, 1e-3) << radius;
    }
}

TEST(SimplifiedLines, StayApartAndMeetAtAnAngle) {
    // A lens between two nodes, of which one side only may become straight, and a line that a chord would come near.
    const DenseLine upper{{{0, 0}, {2, 1}, {4, 1.4}, {6, 1}, {8, 0}}, 20, 5, 0, false};
    const DenseLine lower{{{0, 0}, {2, -1}, {4, -1.4}, {6, -1}, {8, 0}}, 20, 5, 0, false};
    const auto lens = simplified_lines(std::vector{upper, lower}, {0.5, 0.1});
    EXPECT_GE(lens[0].size() + lens[1].size(), 5U);
    for (const double distance : {0.1, 0.5}) {
        const DenseLine near{{{3, 0.3}, {5, 0.3}}, 20, 5, 0, false};
        const DenseLine dent{{{0, 0}, {2, 0}, {4, -2}, {6, 0}, {8, 0}}, 20, 5, 0, false};
        EXPECT_EQ(simplified_lines(std::vector{dent, near}, {distance, 0.1})[0].size() == 2, distance < 0.3) << distance;
    }
    const DenseLine one{{{0, 0}, {2, 2}}, 1, 1, 0, false};
    const DenseLine other{{{0, 2}, {2, 0}}, 1, 1, 0, false};
    EXPECT_THROW(simplified_lines(std::vector{one, other}, needed), UsageError) << "crossed before";
}

}  // namespace
}  // namespace graincrack::mesher
