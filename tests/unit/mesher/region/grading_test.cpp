#include "mesher/region/grading.hpp"

#include <gtest/gtest.h>

#include "mesher/region/shapes.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden.hpp"

namespace graincrack::mesher {
namespace {

TEST(Grading, IsReadOrRefused) {
    const Grading along = parse_grading("to=2,along=x,from=0.5", "--grade");
    EXPECT_EQ(along.kind, Grading::Kind::along_x);
    EXPECT_EQ(along.from, 0.5);
    EXPECT_EQ(along.to, 2);
    const Grading towards = parse_grading("towards=flaws,from=0.4,distance=10mm", "--grade");
    EXPECT_EQ(towards.kind, Grading::Kind::towards_flaws);
    EXPECT_EQ(towards.to, 1);
    EXPECT_EQ(towards.distance, 0.01);
    test::Refusals refused;
    for (const char* text : {"", "along=y", "along=y,from=0.5", "along=z,from=0.5,to=2", "along=y,from=0.05,to=2",
                             "along=y,from=0.5,to=11", "along=y,from=0.5,to=2,distance=1mm", "towards=flaws,from=0.5",
                             "towards=flaws,from=0.5,to=1,distance=1mm", "towards=flaws,from=0.5,distance=0mm",
                             "along=x,along=y,from=1,to=2", "along=y,from=nan,to=2", "along=y,,from=1,to=2"}) {
        refused.add<UsageError>(text, [&] { (void)parse_grading(text, "--grade"); });
    }
    test::expect_golden(refused.text());
}

TEST(Grading, GrowsLinearlyWithTheDistance) {
    Region region = rectangle(0.08, 0.16);
    const auto graded = [&](const char* text) { return GradedSize(parse_grading(text, "--grade"), region); };
    region.edges = {{{-0.01, 0}, {0.01, 0}}};
    add_hole(region, {0, 0.05}, 0.01, "--hole");
    const GradedSize flaws = graded("towards=flaws,from=0.4,distance=10mm");
    EXPECT_DOUBLE_EQ(flaws.at({0, 0}), 0.4);
    EXPECT_DOUBLE_EQ(flaws.at({0.015, 0}), 0.7);
    EXPECT_DOUBLE_EQ(flaws.at({0, -0.05}), 1);
    EXPECT_DOUBLE_EQ(flaws.slope(), 60);
    EXPECT_DOUBLE_EQ(graded("towards=holes,from=0.4,distance=10mm").at({0, 0.035}), 0.7);
    EXPECT_DOUBLE_EQ(graded("towards=boundary,from=2,distance=10mm").at({-0.035, 0}), 1.5);
    EXPECT_DOUBLE_EQ(graded("along=x,from=1,to=3").at({0.02, 0.01}), 2.5);
}

}  // namespace
}  // namespace graincrack::mesher
