#include "mesher/region/joint_set.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/region/shapes.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden.hpp"

namespace graincrack::mesher {
namespace {

TEST(JointSet, IsReadOrRefused) {
    const JointSet set = parse_joint_set("spacing=20mm,dip=45deg,persistence=0.7,length=30mm,class=intact", "--joint-set");
    EXPECT_EQ(set.spacing, 0.02);
    EXPECT_NEAR(set.dip, 0.785398163397448, 1e-15);
    EXPECT_EQ(set.persistence, 0.7);
    EXPECT_EQ(set.length, 0.03);
    EXPECT_EQ(set.kind, FlawKind(ContactKind::grain_boundary));
    EXPECT_EQ(parse_joint_set("spacing=1mm,dip=0deg", "").kind, FlawKind(ContactKind::pre_existing_crack));
    EXPECT_EQ(parse_joint_set("spacing=1mm,dip=0deg,state=broken,class=joint", "").kind,
              FlawKind(ContactKind::pre_existing_crack, "joint"));
    EXPECT_EQ(parse_joint_set("dip=0,spacing=5mm", "--joint-set").length, 0.005);
    test::Refusals refused;
    for (const char* text : {"", "spacing=20mm", "dip=45deg", "spacing=0mm,dip=0deg", "spacing=1mm,dip=0deg,persistence=0",
                             "spacing", "spacing=1mm,dip=0deg,class=New", "spacing=1mm,dip=0deg,class=broken,state=intact",
                             "spacing=1mm,dip=0deg,state=new", "spacing=1mm,,dip=0deg"}) {
        refused.add<UsageError>(text, [&] { (void)parse_joint_set(text, "--joint-set 2"); });
    }
    test::expect_golden(refused.text());
}

TEST(JointSet, HasItsSpacingDirectionAndPersistence) {
    const Region region = rectangle(1, 1);
    JointSet set{0.02, 0.5, 0.6, 0.03, ContactKind::pre_existing_crack, "--joint-set"};
    for (const double persistence : {0.6, 1.0}) {
        set.persistence = persistence;
        double jointed = 0;
        for (const PrescribedEdge& joint : joints_of(set, region, 2e-3, 3, 0)) {
            const Point way = joint.to - joint.from;
            EXPECT_NEAR(std::atan2(way.y, way.x), 0.5, 1e-9);
            EXPECT_FALSE(joint.needed);
            for (const PrescribedEdge& piece : clip(region, joint)) jointed += length(piece.to - piece.from);
        }
        EXPECT_NEAR(jointed * 0.02, persistence, persistence < 1 ? 0.02 : 0.01) << "length in an area of 1 m2 times spacing";
    }
}

TEST(JointSet, FollowsSeedAndNumberAndKeepsRoomForGrains) {
    const Region region = rectangle(0.1, 0.1);
    const JointSet set{0.02, 0.5, 0.6, 0.03, ContactKind::pre_existing_crack, "--joint-set"};
    const auto first = [&](std::uint64_t seed, std::size_t number) { return joints_of(set, region, 2e-3, seed, number)[0].from; };
    EXPECT_EQ(first(3, 0), first(3, 0));
    EXPECT_NE(first(3, 0), first(4, 0));
    EXPECT_NE(first(3, 0), first(3, 1));
    EXPECT_THROW((void)joints_of(set, region, 0.011, 3, 0), UsageError);
    EXPECT_THROW((void)joints_of({1e-6, 0, 1, 1e-6, {}, "--joint-set"}, region, 1e-7, 3, 0), UsageError);
}

}  // namespace
}  // namespace graincrack::mesher
