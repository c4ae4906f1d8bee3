// Pictures by the positions of their lines and markers, and by their words.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>

#include "post/plot/plots.hpp"
#include "share/base/error.hpp"
#include "tests/support/drawing_shapes.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

using test::lines_of;

class Plot : public test::RunFolder {
protected:
    void SetUp() override { test::write_run(path("run.h5"), recipe_); }
    RunData run() const { return read_run_data(path("run.h5")); }
    test::Recipe recipe_;
};

TEST_F(Plot, HasLinesAtTheDefaultThresholdsAndTurnsTheVolumeAtCrackDamage) {
    RunData data = run();
    test::widen(data.history, recipe_, 4e-7);
    const Drawing page = draw_thresholds(data);
    test::expect_golden(page.words());
    // Level above, upright below, and in the legend.
    for (const Colour colour : {palette::tensile, palette::shear}) {
        const auto lines = lines_of(page, colour, 3);
        ASSERT_EQ(lines.size(), 3U);
        EXPECT_EQ(lines[0].points.front().y, lines[0].points.back().y);
        EXPECT_EQ(lines[2].points.front().x, lines[2].points.back().x);
    }
    const auto damage = lines_of(page, palette::shear, 3);
    const auto volumes = lines_of(page, palette::series(2), 4);  // above, its legend, below, its legend
    ASSERT_EQ(volumes.size(), 4U);
    const auto farthest = std::ranges::max_element(volumes[0].points, {}, &Pixel::x);
    EXPECT_NEAR(farthest->y, damage[0].points[0].y, 0.5);
    const auto highest = std::ranges::min_element(volumes[2].points, {}, &Pixel::y);
    EXPECT_NEAR(highest->x, damage[2].points[0].x, 0.5);
}

TEST_F(Plot, HasEnergyOverTimeWithoutWhatIsNothing) {
    RunData data = run();
    for (double& value : data.history[HistoryColumn::energy_external]) value = 1000;
    for (double& value : data.history[HistoryColumn::energy_kinetic]) value = 0.9;
    for (double& value : data.history[HistoryColumn::energy_platen]) value = -1.1;
    const Drawing page = draw_energy(data);
    test::expect_golden(page.words());
    EXPECT_TRUE(lines_of(page, palette::series(6), 2.5).empty());
}

TEST_F(Plot, HasACurveOfTheLawOfTheMaterial) {
    const ContactParameters contact = test::synthetic_header({}).contact;
    test::expect_golden(draw_laws(contact, "granite", {}).words());
    const Drawing page = draw_laws(contact, "granite", {.laws = {}, .all = true, .own = "cohesive-frictional"});
    EXPECT_LT(page.height(), 1900);
    EXPECT_EQ(lines_of(page, palette::ink, 4).size(), 4U);  // three charts and the legend
    test::expect_golden(page.words(), "all");
}

// Before the first crack they would cover the axis.
TEST_F(Plot, BeginsCountsBesideACurveWithTheFirstCrack) {
    const RunData data = run();
    const Drawing page = draw_curves({data}, "what a crack is");
    const std::vector<Polyline> frame = lines_of(page, palette::ink, 1.8);
    ASSERT_EQ(frame.size(), 1U);
    for (const Colour colour : {palette::tensile, palette::shear}) {
        const std::vector<Polyline> lines = lines_of(page, colour);
        ASSERT_FALSE(lines.empty());
        const auto& points = lines.front().points;
        const auto on_axis = [&](const Pixel& at) { return at.y > frame[0].points[0].y - 0.5; };
        EXPECT_LE(std::count_if(points.begin(), points.end(), on_axis), 1);
    }
}

TEST_F(Plot, FillsGrainsByStressOrDisplacementWithAScaleOfColours) {
    using Fills = std::set<std::array<int, 3>>;
    const RunReader run(path("run.h5"));
    std::string words;
    const auto fills_of = [&](MapFill fill) {
        const Drawing page = draw_cracks(run, {.frame = "peak", .time = {}, .fill = fill});
        words += page.words() + "\n";
        Fills fills;
        for (const Drawing::Shape& shape : page.shapes()) {
            const auto* triangles = std::get_if<Polygons>(&shape);
            if (triangles == nullptr || triangles->sides != 3) continue;
            fills.insert({triangles->fill.red, triangles->fill.green, triangles->fill.blue});
        }
        return fills;
    };
    // 1, −100 and 5 MPa everywhere: σ1 = 49.5 + √(50.5² + 5²) = 100.2, σ3 = −1.25 MPa, the ends of their scales.
    EXPECT_EQ(fills_of(MapFill::sigma1), (Fills{{0, 40, 90}}));
    EXPECT_EQ(fills_of(MapFill::sigma3), (Fills{{120, 40, 0}}));
    EXPECT_GT(fills_of(MapFill::displacement).size(), 3U);
    EXPECT_EQ(fills_of(MapFill::mineral).size(), 1U);
    test::expect_golden(words);
}

TEST_F(Plot, WritesAllFramesAsNumberedPicturesOfOneSize) {
    const RunReader run(path("run.h5"));
    const CrackMapOptions options{"all", std::nullopt, 20};
    PictureStyle style;
    const auto height = [&](const char* frame) { return draw_cracks(run, {frame, std::nullopt, 20}, style).height(); };
    while (style.page_width > 400 && height("first") == height("last")) style.page_width -= 20;  // a heading of another line
    ASSERT_NE(height("first"), height("last"));
    const auto write = [&](const std::string& folder) { write_frames(run, options, style, folder, {}, Verbosity::quiet); };
    write(path("frames"));
    std::set<std::string> sizes;
    std::size_t pictures = 0;
    for (const auto& each : std::filesystem::directory_iterator(path("frames"))) {
        std::string header(24, ' ');
        std::ifstream(each.path()).read(header.data(), 24);
        sizes.insert(header.substr(16));  // width and height
        ++pictures;
    }
    EXPECT_EQ(pictures, run.frame_times().size());
    EXPECT_EQ(sizes.size(), 1U);
    test::GoldenRefusals().add<UsageError>("a film", [&] { write(path("frames.mp4")); });
}

}  // namespace
}  // namespace graincrack
