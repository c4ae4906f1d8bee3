#include "solver/program/standard_tests.hpp"

#include <gtest/gtest.h>

#include "share/base/error.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::test {
namespace {

/// 90 mm × 20 mm with boundary edges of 5 mm, whose nodes lie at multiples of it.
Specimen beam() {
    Specimen s = union_jack_grid(18, 4, 0.09, 0.02);
    s.shape = "beam";
    return s;
}

ProgramPlatens bent(const Specimen& s, std::optional<double> span, std::optional<double> roller_width = {}) {
    const LoadingRequest request{.test = TestKind::bend, .rate = RateKind::automatic, .span = span, .roller_width = roller_width};
    return *standard_test(request, 0.3, s, augig_granite().rock).platens;
}

TEST(Bend, PlacesItsRollersAtTheNodesNextToTheirPlaces) {
    const ProgramPlatens platens = bent(beam(), 0.062);
    ASSERT_EQ(platens.bottom.at.size(), 2U);
    EXPECT_NEAR(platens.bottom.at[0], -0.03, 1e-12);
    EXPECT_NEAR(platens.bottom.at[1], 0.03, 1e-12);
    ASSERT_EQ(platens.top.at.size(), 1U);
    EXPECT_NEAR(platens.top.at[0], 0, 1e-12);
    EXPECT_NEAR(platens.span(), 0.06, 1e-12);
    EXPECT_NEAR(platens.bottom.width, 0.005, 1e-12);
    EXPECT_EQ(bent(beam(), 0.062, 0.002).top.width, 0.002);
}

TEST(Bend, HasUsualSpans) {
    EXPECT_NEAR(bent(beam(), {}).span(), 0.08, 1e-12);  // four heights
    Specimen half_disc = union_jack_grid(20, 10, 0.1, 0.05);
    half_disc.shape = "half-disc";
    EXPECT_NEAR(bent(half_disc, {}).span(), 0.06, 1e-12);  // 0.6 diameters
}

TEST(StandardTests, AreSlowerInBendingAndSlowestInDirectTension) {
    const auto tolerance = [](TestKind test) { return LoadingRequest{.test = test}.automatic_tolerance(); };
    EXPECT_EQ(tolerance(TestKind::uniaxial), default_rate_tolerance);
    EXPECT_LT(tolerance(TestKind::bend), default_rate_tolerance);
    EXPECT_LT(tolerance(TestKind::brazilian), tolerance(TestKind::bend));
    EXPECT_LT(tolerance(TestKind::tension), tolerance(TestKind::brazilian));
}

TEST(Bend, RefusesRollersWithoutRoom) {
    Specimen low = union_jack_grid(8, 8, 0.04, 0.04);
    low.shape = "beam";
    Refusals refused;
    refused.add<UsageError>("span of the width", [] { bent(beam(), 0.09); });
    refused.add<UsageError>("span below two rollers", [] { bent(beam(), 0.008); });
    refused.add<UsageError>("three wide rollers", [] { bent(beam(), 0.06, 0.04); });
    refused.add<UsageError>("two wide rollers", [] { bent(beam(), 0.04, 0.03); });
    refused.add<UsageError>("low beam", [&] { bent(low, {}); });
    expect_golden(refused.text());
}

TEST(StandardTests, LoadTheShapesTheyAreMadeFor) {
    const auto loads = [](TestKind test, const Specimen& specimen) {
        try {
            require_shape(test, specimen, "s.h5");
        } catch (const InputError&) {
            return false;
        }
        return true;
    };
    const auto named = [](const char* shape, bool has_faces) {
        Specimen s = union_jack_grid(8, 4, 0.08, 0.04);
        s.shape = shape;
        if (!has_faces) s.boundary_part.assign(s.n_boundary_edges(), static_cast<std::uint8_t>(BoundaryPart::rim));
        return s;
    };
    for (const char* shape : {"disc", "ring"}) {
        EXPECT_TRUE(loads(TestKind::brazilian, named(shape, false)));
        EXPECT_FALSE(loads(TestKind::bend, named(shape, false)));
        EXPECT_FALSE(loads(TestKind::tension, named(shape, false)));
    }
    EXPECT_TRUE(loads(TestKind::bend, named("beam", true)));
    EXPECT_TRUE(loads(TestKind::uniaxial, named("beam", true)));
    EXPECT_TRUE(loads(TestKind::bend, named("half-disc", false)));
    EXPECT_FALSE(loads(TestKind::uniaxial, named("half-disc", false)));
    EXPECT_FALSE(loads(TestKind::brazilian, named("rectangle", true)));
    EXPECT_FALSE(loads(TestKind::bend, named("rectangle", true)));
    EXPECT_TRUE(loads(TestKind::triaxial, named("polygon", true)));
    EXPECT_FALSE(loads(TestKind::triaxial, named("polygon", false)));
    EXPECT_TRUE(loads(TestKind::program, named("polygon", false)));
}

}  // namespace
}  // namespace graincrack::test
