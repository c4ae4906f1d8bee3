// Pictures by the positions of their lines and markers, and by their words.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
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

double distance(Pixel p, Pixel a, Pixel b) {
    const Pixel d{b.x - a.x, b.y - a.y};
    const double length = d.x * d.x + d.y * d.y;
    const double share = length > 0 ? std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / length, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - share * d.x, p.y - a.y - share * d.y);
}

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

TEST_F(ThresholdsPlot, AllDefinitionsHaveMarksAndThoseThatCoincideShareOne) {
    std::vector<Crack> cracks = test::synthetic_cracks(test::Recipe().specimen);
    for (Crack& crack : cracks) crack.damaged_10.time = crack.damaged_50.time = 0.6;
    PictureStyle wide;
    wide.page_width = 2000;  // each entry of the legend has one line
    const Drawing page = draw_thresholds(data_, ThresholdMarks::all, wide, cracks);
    EXPECT_TRUE(says(page, "count of cracks, 1\u00a0%: ")) << page.words();
    EXPECT_TRUE(
        says(page, "CI by 1\u00a0% of the points damaged by 10\u00a0%; 1\u00a0% of the points damaged by 50\u00a0%: 75.0 MPa\n"))
        << page.words();
    EXPECT_TRUE(says(page, "Not reached before the peak: CI by 1\u00a0% of the points damaged by 90\u00a0%."));
    EXPECT_TRUE(says(page, "CD by reversal of volumetric strain, 2D: ") && says(page, "crack damage CD: ")) << page.words();
    // The mark of the smallest stress lies on the axial strain.
    const auto axial = lines_of(page, palette::series(0), 4.5);
    const auto markers = lines_of(page, palette::series(0), 0.15 * 26);  // in the frame and in the legend
    ASSERT_EQ(axial.size(), 2U);
    ASSERT_EQ(markers.size(), 2U);
    const auto& curve = axial[0].points;
    const Pixel place{markers[0].points[0].x, markers[0].points[0].y + 1.2 * 13};  // below the tip of the triangle
    double nearest = 1e300;
    for (std::size_t i = 1; i < curve.size(); ++i) nearest = std::min(nearest, distance(place, curve[i - 1], curve[i]));
    EXPECT_LT(nearest, 0.5);
    // A definition that coincides with the default is named there.
    const double initiation = *measure_thresholds(load_curve(data_), VolumeKind::pseudo_3d).initiation_by_crack_strain;
    for (Crack& crack : cracks) crack.damaged_10.time = initiation / 125e6 - 1e-9;
    const Drawing same = draw_thresholds(data_, ThresholdMarks::all, wide, cracks);
    EXPECT_TRUE(says(same, "of the peak; the same by 1\u00a0% of the points damaged by 10\u00a0%\n")) << same.words();
}

TEST_F(Plot, EnergyIsOverTimeOrStrainAndLeavesOutWhatIsNothing) {
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
    EXPECT_TRUE(says(draw_energy(data, Abscissa::strain), "axial strain, %\n"));
}

TEST_F(Plot, CountsNamePairsOfMineralsAndLeaveOutThoseWithoutCracks) {
    const RunData data = run();
    CrackCounts counts;
    counts.classes = {"k_feldspar-k_feldspar", "k_feldspar-mica", "mica-mica", "quartz-quartz"};
    for (std::size_t row = 0; row < data.history.size(); ++row) {
        CrackCounts::Moment moment;
        moment.by_class.resize(4);
        moment.by_class[1].tensile = static_cast<double>(row);
        moment.all = moment.by_class[1];
        counts.moments.push_back(moment);
    }
    const Drawing usual = draw_counts(counts, data, "what a crack is");
    EXPECT_TRUE(says(usual, "\ntensile\nshear\nstress, right\n")) << usual.words();
    EXPECT_FALSE(says(usual, "feldspar"));
    const CountsOptions classes{.by_class = true};
    const Drawing few = draw_counts(counts, data, "what a crack is", classes);
    EXPECT_TRUE(says(few, "K-feldspar–mica, tensile\n")) << few.words();
    EXPECT_FALSE(says(few, "shear") || says(few, "quartz")) << few.words();
    EXPECT_TRUE(says(few, "pairs without cracks of a mode have no curve\n"));
    for (int k = 0; k < 6; ++k) counts.classes.push_back("mineral" + std::to_string(k));
    for (CrackCounts::Moment& moment : counts.moments) {
        moment.by_class.resize(10);
        for (std::size_t k = 0; k < 10; ++k) moment.by_class[k].shear = static_cast<double>(10 - k);
        moment.all.shear = 55;
    }
    const Drawing many = draw_counts(counts, data, "what a crack is", classes);
    EXPECT_TRUE(says(many, "other pairs, shear\n"));
    EXPECT_FALSE(says(many, "mineral5"));
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
    const Drawing page = draw_curves({data}, {}, "what a crack is");
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

TEST_F(Plot, FragmentsStandBetweenThePlatensWithTheStressOfTheFrame) {
    const Drawing page = draw_fragments(RunReader(path("run.h5")), {"peak", std::nullopt, 1});
    EXPECT_TRUE(says(page, "1 fragment\nthe largest has 100.0 % of the area\nstrain ")) << page.words();
    EXPECT_TRUE(says(page, "stress 125.0 MPa (peak)")) << page.words();
    const auto is_platen = [](const Drawing::Shape& shape) {
        const auto* polygons = std::get_if<Polygons>(&shape);
        return polygons != nullptr && polygons->fill == palette::platen;
    };
    EXPECT_TRUE(std::any_of(page.shapes().begin(), page.shapes().end(), is_platen));
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

TEST_F(Plot, StrengthsStandBesideTheLaboratorysAtTheirPressure) {
    RunData confined = run();
    confined.header.test = "triaxial";
    confined.header.confining_pressure = 8e6;
    const auto marks = [&](const std::vector<RunData>& runs) {
        const Drawing page = draw_strengths(runs, read_material("augig-granite"), {});
        EXPECT_TRUE(says(page, "strength, MPa (logarithmic)\n") && says(page, "laboratory")) << page.words();
        return lines_of(page, palette::tensile, 3.5).size();
    };
    EXPECT_EQ(marks({run(), confined}), marks({run()}) + 1);
    EXPECT_FALSE(says(draw_strengths({run()}, std::nullopt), "laboratory"));
}

TEST_F(Plot, WarningsStandBelowNotInTheHeading) {
    const std::string words = draw_strengths({run()}, std::nullopt, {"uniaxial: did not fail (1 of 1 run)"}).words();
    EXPECT_GT(words.find("did not fail (1 of 1 run)"), words.find("strength of a run")) << words;
    EXPECT_NE(words.find("did not fail (1 of 1 run)"), std::string::npos);
}

}  // namespace
}  // namespace graincrack
