#include "post/measure/brazilian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "post/cracks/crack_network.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/strength_table.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

using test::field;
using test::Recipe;

constexpr int rows_of_disc = 10;

/// Both points of the upright facets on x = 0 of a 6 × 10 grid, from the middle outwards, one facet every 0.1 s.
std::vector<Crack> split(const Specimen& s, int facets) {
    std::vector<Crack> cracks;
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto& a = s.node_position[static_cast<std::size_t>(s.contact_nodes[c][0])];
        const auto& b = s.node_position[static_cast<std::size_t>(s.contact_nodes[c][1])];
        if (std::abs(a[0]) > 1e-9 || std::abs(b[0]) > 1e-9) continue;
        for (std::uint8_t point = 0; point < 2; ++point) {
            Crack crack;
            crack.contact = static_cast<std::int32_t>(c);
            crack.point = point;
            crack.position = {0, (point == 0 ? 0.75 : 0.25) * a[1] + (point == 0 ? 0.25 : 0.75) * b[1]};
            crack.time = 0.1 * std::floor(1 + std::abs(a[1] + b[1]) / 2 / (s.height / rows_of_disc));
            cracks.push_back(crack);
        }
    }
    std::ranges::stable_sort(cracks, [](const Crack& a, const Crack& b) { return a.time < b.time; });
    cracks.resize(static_cast<std::size_t>(2 * facets));
    return cracks;
}

Recipe disc() {
    Recipe recipe{.test = "brazilian", .plane = PlaneCondition::stress, .peak = 10e6};
    recipe.specimen = test::grid_specimen(6, rows_of_disc, 0.08, 0.08);
    recipe.specimen.loading_arc = 0.1;
    return recipe;
}

RunData run_of(const Recipe& recipe) {
    const Specimen& s = recipe.specimen;
    return {"run.h5", test::synthetic_header(recipe), test::synthetic_history(recipe), {s.width, s.height}, 1};
}

TEST(CrackNetwork, HasOneCornerForNodesAtOnePlace) {
    const Specimen s = test::grid_specimen(4, 4, 0.04, 0.04);
    const std::vector<std::size_t> corners = corners_of_nodes(s);
    for (std::size_t i = 0; i < s.n_nodes(); ++i) {
        for (std::size_t j = 0; j < s.n_nodes(); ++j) {
            const bool same =
                std::hypot(s.node_position[i][0] - s.node_position[j][0], s.node_position[i][1] - s.node_position[j][1]) < 1e-9;
            EXPECT_EQ(corners[i] == corners[j], same) << i << " " << j;
        }
    }
}

TEST(CrackNetwork, ReachesAlongTheLoadAsItGrows) {
    const Recipe recipe = disc();
    CrackNetwork network(recipe.specimen);
    double reach = 0;
    for (const Crack& crack : split(recipe.specimen, 8)) reach = network.add(crack);
    EXPECT_NEAR(reach, 0.8 * 0.08, 1e-12);  // eight facets of ten hang together
}

TEST(CrackNetwork, ReachesAcrossShearCracksButNotAlongThem) {
    const Recipe recipe = disc();
    std::vector<Crack> cracks = split(recipe.specimen, 8);
    for (Crack& crack : cracks) {
        if (std::abs(crack.position[1]) > 0.02) crack.mode = CrackMode::shear;
    }
    CrackNetwork network(recipe.specimen);
    double reach = 0;
    for (const Crack& crack : cracks) reach = std::max(reach, network.add(crack));
    EXPECT_GT(reach, 0.03);
    EXPECT_LT(reach, 0.05);
}

TEST(Brazilian, HasTheLoadOfTheTimeOfTheSpan) {
    Recipe recipe = disc();
    recipe.specimen.loading_arc = std::numbers::pi / 2;  // of the side of its square
    test::TemporaryFolder folder;
    const auto table_of = [&](int facets) {
        test::write_run(folder.file("run.h5"), recipe, split(recipe.specimen, facets));
        std::ostringstream out, notes;
        write_strength_table(out, {folder.file("run.h5")}, TableFormat::tsv, notes);
        return out.str();
    };
    // The curve rises evenly to 10 MPa at 1 s. Eight facets hang together at 0.4 s.
    EXPECT_NEAR(test::number_in(table_of(8), "spanning_strength_MPa"), 4, 1e-3);
    EXPECT_EQ(field(table_of(6), "spanning_strength_MPa"), "");
    EXPECT_NEAR(test::number_in(table_of(8), "loading_arc_deg"), 90, 1e-5);
    test::expect_golden(field(table_of(8), "warning") + "\n" + field(table_of(6), "warning"));
}

TEST(Brazilian, SplitsByOpenCracksOfAnyTraction) {
    const Recipe recipe = disc();
    const RunData run = run_of(recipe);
    const LoadCurve curve = load_curve(run);
    std::vector<Crack> cracks = split(recipe.specimen, 8);
    for (Crack& crack : cracks) crack.mode_angle = 1.2;  // more shear than tension: open cracks of shear by their traction
    EXPECT_TRUE(measure_split(run, curve, recipe.specimen, cracks).spanning_stress);
    for (Crack& crack : cracks) crack.opening = -1e-6;
    EXPECT_FALSE(measure_split(run, curve, recipe.specimen, cracks).spanning_stress);
}

TEST(Brazilian, HasNoWarningIfTheSplitIsThePeakAndBeginsInside) {
    const Recipe recipe = disc();
    std::vector<Crack> cracks = split(recipe.specimen, 8);
    for (Crack& crack : cracks) crack.time = 0.6 + crack.time;  // the span at 1 s
    const RunData run = run_of(recipe);
    const LoadCurve curve = load_curve(run);
    const BrazilianSplit inside = measure_split(run, curve, recipe.specimen, cracks);
    EXPECT_EQ(inside.warning(), "");
    EXPECT_LT(*inside.first_crack_radius, 0.2);
    // The load falls as the cracks span the disc, and cracks scatter before.
    RunData fallen = run_of(recipe);
    fallen.history[HistoryColumn::axial_stress].back() *= 0.5;
    std::vector<Crack> scattered = cracks;
    for (Crack& crack : scattered) crack.position[0] += crack.position[0] < 0 ? -0.028 : 0.028;
    EXPECT_EQ(measure_split(fallen, load_curve(fallen), recipe.specimen, scattered).warning(), "");
    for (Crack& crack : cracks) crack.position[0] = 0.035;  // the same times and network, but by the rim
    const BrazilianSplit outside = measure_split(run, curve, recipe.specimen, cracks);
    EXPECT_NEAR(*outside.first_crack_radius, 0.875, 0.03);
    test::expect_golden(outside.warning());
}

TEST(Brazilian, DoesNotSplitARing) {
    RunData run = run_of(disc());
    EXPECT_TRUE(splits(run));
    run.specimen.shape = "ring";
    EXPECT_FALSE(splits(run));
}

TEST(Brazilian, HasACaveatForFlatPoles) {
    EXPECT_EQ(strength_share_of_arcs(0), 1);
    EXPECT_NEAR(strength_share_of_arcs(20 * std::numbers::pi / 180), 0.96, 1e-3);
    Recipe recipe = disc();
    recipe.specimen.shape = "disc";
    recipe.specimen.height = recipe.specimen.width * std::cos(10 * std::numbers::pi / 180);
    const RunData run = run_of(recipe);
    const BrazilianSplit split = measure_split(run, load_curve(run), recipe.specimen, {});
    ASSERT_FALSE(split.caveats.empty());
    test::expect_golden(split.caveats.front().kind + "\n" + split.warning());
}

}  // namespace
}  // namespace graincrack
