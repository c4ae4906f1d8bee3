// Pictures by the positions of their lines and markers, and by their words.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "post/measure/thresholds.hpp"
#include "post/plot/plots.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/drawing_shapes.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

using test::lines_of;

bool says(const Drawing& drawing, const std::string& words) { return drawing.words().find(words) != std::string::npos; }

class Plot : public ::testing::Test {
protected:
    void SetUp() override { test::write_run(path("run.h5"), recipe_); }
    std::string path(const std::string& name) const { return folder_.file(name); }
    RunData run() const { return read_run_data(path("run.h5")); }
    test::Recipe recipe_;
    test::TemporaryFolder folder_;
};

class ThresholdsPlot : public Plot {
protected:
    void SetUp() override {
        Plot::SetUp();
        data_ = run();
        test::widen(data_.history, recipe_, 4e-7);
    }
    RunData data_;
};

TEST_F(ThresholdsPlot, LinesAreAtTheDefaultThresholdsWithTheirShareOfThePeak) {
    const LoadCurve curve = load_curve(data_);
    const Thresholds gauges = measure_thresholds(curve, VolumeKind::pseudo_3d);
    ASSERT_TRUE(gauges.initiation_by_crack_strain && gauges.damage);
    const Drawing page = draw_thresholds(data_);
    const auto expected = [&](const std::string& name, double stress) {
        return fmt::format("{}: {:.1f} MPa, {:.2f} of the peak\n", name, stress * 1e-6, stress / 125e6);
    };
    EXPECT_TRUE(says(page, expected("crack initiation CI", *gauges.initiation_by_crack_strain))) << page.words();
    EXPECT_TRUE(says(page, expected("crack damage CD", *gauges.damage))) << page.words();
    EXPECT_FALSE(says(page, "count") || says(page, "2D")) << page.words();
    // Level above, upright below, and in the legend.
    for (const Colour colour : {palette::tensile, palette::shear}) {
        const auto lines = lines_of(page, colour, 3);
        ASSERT_EQ(lines.size(), 3U);
        EXPECT_EQ(lines[0].points.front().y, lines[0].points.back().y);
        EXPECT_EQ(lines[2].points.front().x, lines[2].points.back().x);
    }
}

TEST_F(ThresholdsPlot, VolumeTurnsWhereCrackDamageIs) {
    const Drawing page = draw_thresholds(data_);
    const auto volumes = lines_of(page, palette::series(2), 4);  // above, its legend, below, its legend
    ASSERT_EQ(volumes.size(), 4U);
    const auto& above = volumes[0].points;
    const auto farthest = std::max_element(above.begin(), above.end(), [](Pixel a, Pixel b) { return a.x < b.x; });
    EXPECT_NEAR(farthest->y, lines_of(page, palette::shear, 3)[0].points[0].y, 0.5);
    const auto& below = volumes[2].points;
    const auto highest = std::min_element(below.begin(), below.end(), [](Pixel a, Pixel b) { return a.y < b.y; });
    EXPECT_NEAR(highest->x, lines_of(page, palette::shear, 3)[2].points[0].x, 0.5);
}

TEST_F(Plot, EnergyIsOverTimeAndLeavesOutWhatIsNothing) {
    RunData data = run();
    for (double& value : data.history[HistoryColumn::energy_external]) value = 1000;
    for (double& value : data.history[HistoryColumn::energy_kinetic]) value = 0.9;
    for (double& value : data.history[HistoryColumn::energy_platen]) value = -1.1;
    const Drawing page = draw_energy(data);
    EXPECT_TRUE(says(page, "time, ms\n") && says(page, "\nplatens\n")) << page.words();
    EXPECT_FALSE(says(page, "\nkinetic\n"));
    EXPECT_TRUE(says(page, "below 0.1 % of the largest, and not shown: "));
    EXPECT_TRUE(says(page, "kinetic")) << page.words();
    EXPECT_TRUE(lines_of(page, palette::series(6), 2.5).empty());
}

TEST_F(Plot, TheLawOfTheMaterialHasACurveOfItsOwn) {
    LawPlotOptions options;
    options.own = "cohesive-frictional";
    options.all = true;
    const Material material = read_material(std::string(GRAINCRACK_SOURCE) + "/share/materials/augig-granite.toml");
    const ContactParameters contact = contact_parameters(material, PlaneCondition::strain, std::nullopt);
    const Drawing page = draw_laws(contact, "granite", options);
    EXPECT_EQ(lines_of(page, palette::ink, 4).size(), 4U);  // three charts and the legend
    EXPECT_TRUE(says(page, "cohesive-frictional (the material's own)\n"));
    const Drawing own = draw_laws(contact, "granite", {});
    EXPECT_TRUE(says(own, "consistent (the material's own)\n"));
    EXPECT_FALSE(says(own, "coulomb-slip") || says(own, "law without a curve")) << own.words();
}

// Before the first crack they would cover the axis.
TEST_F(Plot, CountsBesideACurveBeginWithTheFirstCrack) {
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

TEST_F(Plot, MapsSideBySideHaveOneScaleBarAndTellWhereTheyStand) {
    recipe_.drop = 1;
    test::write_run(path("run.h5"), recipe_);
    const Drawing page = draw_cracks(RunReader(path("run.h5")), {"first,peak,last", std::nullopt, 1});
    const std::string words = page.words();
    for (const char* place : {"(a) before loading\n", "(c) after, 0 %\n"}) EXPECT_TRUE(says(page, place)) << words;
    const std::size_t bar = words.find(" mm\n", words.find("counts are contacts"));
    EXPECT_NE(bar, std::string::npos) << words;
    EXPECT_EQ(words.find(" mm\n", bar + 1), std::string::npos) << words;
}

TEST_F(Plot, GrainsAreFilledByStressOrDisplacementWithAScaleOfColours) {
    const RunReader run(path("run.h5"));
    const auto fills_of = [&](MapFill fill, const std::string& words) {
        CrackMapOptions options;
        options.frame = "peak";
        options.fill = fill;
        const Drawing page = draw_cracks(run, options);
        EXPECT_TRUE(says(page, words)) << page.words();
        std::set<std::array<int, 3>> fills;
        for (const Drawing::Shape& shape : page.shapes()) {
            const auto* triangles = std::get_if<Polygons>(&shape);
            if (triangles == nullptr || triangles->sides != 3) continue;
            fills.insert({triangles->fill.red, triangles->fill.green, triangles->fill.blue});
        }
        return fills;
    };
    using Fills = std::set<std::array<int, 3>>;
    // 1, −100 and 5 MPa everywhere: σ1 = 49.5 + √(50.5² + 5²) = 100.2, σ3 = −1.25 MPa, the ends of their scales.
    EXPECT_EQ(fills_of(MapFill::sigma1, "greatest compression σ1 in the plane, MPa\n"), (Fills{{0, 40, 90}}));
    EXPECT_EQ(fills_of(MapFill::sigma3, "least compression σ3 in the plane (tension below 0), MPa\n"), (Fills{{120, 40, 0}}));
    EXPECT_GT(fills_of(MapFill::displacement, "displacement, mm\n").size(), 3U);
    EXPECT_EQ(fills_of(MapFill::mineral, "tensile cracks").size(), 1U);
}

TEST_F(Plot, AllFramesAreNumberedPicturesOfOneSize) {
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
    test::expect_one_line<UsageError>([&] { write(path("frames.mp4")); }, {"frames.mp4", "name of a folder"});
}

}  // namespace
}  // namespace graincrack
