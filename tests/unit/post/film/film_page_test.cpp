// Pictures of a film of a run with known answers.
#include "post/film/film_page.hpp"

#include <gtest/gtest.h>

#include "post/chart/font.hpp"
#include "post/film/film.hpp"
#include "post/film/moments.hpp"
#include "post/plot/crack_state.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/drawing_shapes.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

TEST(Between, GoesEvenlyFromPlacesToPlaces) {
    const Positions places = between({{0, 1}, {2, 2}}, {{1, 1}, {2, -2}}, 0.25);
    EXPECT_EQ(places, (Positions{{0.25, 1}, {2, 1}}));
}

class Film : public ::testing::Test {
protected:
    void SetUp() override { test::write_run(path("run.h5"), recipe_); }
    std::string path(const std::string& name) const { return folder_.file(name); }
    test::Recipe recipe_;
    test::TemporaryFolder folder_;
};

/// The strokes of a colour that are as wide as a crack, in the column of the map.
std::size_t strokes_of(const Drawing& drawing, Colour colour) {
    std::size_t n = 0;
    for (const Drawing::Shape& shape : drawing.shapes()) {
        const auto* strokes = std::get_if<Strokes>(&shape);
        if (strokes != nullptr && strokes->colour == colour) n += strokes->size();
    }
    return n;
}

/// The position of the point on the stress–strain curve.
Pixel point_on_curve(const Drawing& drawing) { return test::lines_of(drawing, palette::series(0), 22).at(0).points.front(); }

TEST_F(Film, MovesNodesBetweenTheFrames) {
    const RunReader run(path("run.h5"));
    const Specimen specimen = run.specimen();
    Motion motion(run, specimen, 2);
    const auto top = specimen.n_nodes() - 1;
    const double height = specimen.node_position[top][1];
    EXPECT_DOUBLE_EQ(motion.at({0, 0})[top][1], height);
    EXPECT_NEAR(motion.at({0, 0.5})[top][1], height * (1 - 0.005), 1e-12);  // half of 0.005, twice as large
    EXPECT_NEAR(motion.at({1, 0})[top][1], height * (1 - 0.01), 1e-12);
    EXPECT_NEAR(motion.at({1, 0.5})[top][1], height * (1 - 0.011) + 0.0005, 1e-12);
    EXPECT_NEAR(motion.at({0, 0.1})[top][1], height * (1 - 0.001), 1e-12);  // and back
}

TEST_F(Film, ShowsCracksFromTheirTimeOn) {
    const RunReader run(path("run.h5"));
    FilmPage page(run, {});
    EXPECT_EQ(strokes_of(page.at(0.4), palette::tensile), 0U);
    const std::vector<Crack> cracks = test::synthetic_cracks(recipe_.specimen);
    const double half = cracks[cracks.size() / 2].time;
    std::size_t tensile = 0;
    for (const Crack& crack : cracks) tensile += crack.time <= half && crack.mode_angle < 0.7 ? 1U : 0U;
    EXPECT_EQ(strokes_of(page.at(half), palette::tensile), tensile);
    EXPECT_GT(strokes_of(page.at(1.25), palette::tensile), tensile);
}

TEST_F(Film, ThePointMovesAlongTheCurveAndAllElseStays) {
    const RunReader run(path("run.h5"));
    FilmPage page(run, {});
    const std::vector<double> moments = page.moments(5);
    EXPECT_EQ(moments.front(), 0);
    EXPECT_EQ(moments.back(), 1.25);
    const Drawing first = page.at(moments[0]);
    const Drawing second = page.at(moments[1]);
    const Drawing last = page.at(moments[4]);
    EXPECT_LT(point_on_curve(first).x, point_on_curve(second).x);
    EXPECT_GT(point_on_curve(first).y, point_on_curve(second).y);
    EXPECT_NEAR(point_on_curve(second).x - point_on_curve(first).x, (point_on_curve(last).x - point_on_curve(first).x) / 4, 0.5);
    EXPECT_EQ(first.width(), last.width());
    EXPECT_EQ(first.height(), last.height());
    // Texts that stand where they stood: only their numbers differ.
    const std::vector<Text> before = test::texts_of(first);
    const std::vector<Text> after = test::texts_of(last);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(after[i].at.x, before[i].at.x) << after[i].label;
        EXPECT_EQ(after[i].at.y, before[i].at.y) << after[i].label;
    }
}

TEST_F(Film, WordsLieOnThePageInEverySize) {
    const RunReader run(path("run.h5"));
    for (const char* size : {"1280x720", "640x480", "720x240"}) {
        FilmContents contents;
        contents.size = parse_film_size(size);
        FilmPage page(run, contents);
        const Drawing drawing = page.at(1);
        for (const Text& text : test::texts_of(drawing)) {
            const TextBox box = box_of(text);
            EXPECT_GE(box.left, 0) << text.label;
            EXPECT_GE(box.top, 0) << text.label;
            EXPECT_LE(box.right, drawing.width()) << size << text.label;
            EXPECT_LE(box.bottom, drawing.height()) << size << text.label;
        }
    }
}

TEST_F(Film, NeedsTwoFramesAndAStrainThatChanges) {
    const auto write = [&](const std::string& name, int frames) {
        RunWriter writer(H5Output(path(name), "run"), recipe_.specimen, test::synthetic_header(recipe_));
        writer.append_history(test::synthetic_history(recipe_));
        for (int i = 0; i < frames; ++i) writer.add_frame(test::synthetic_frame(recipe_.specimen, 1, 0, 0), FrameRole::kept);
        writer.finish(test::synthetic_header(recipe_), {}, {});
        return RunReader(path(name));
    };
    test::expect_one_line<InputError>([&] { FilmPage(write("none.h5", 0), {}); }, {"none.h5: has no frames", "--frames"});
    test::expect_one_line<InputError>([&] { FilmPage(write("one.h5", 1), {}); }, {"one.h5: has frames of one time only"});
}

TEST_F(Film, CountsCracksAsItsLegendSays) {
    const RunReader run(path("run.h5"));
    const std::vector<Crack> cracks = read_labelled_cracks(run, run.specimen());
    const std::string words = FilmPage(run, {}).at(1.25).words();
    EXPECT_NE(words.find("tensile cracks: " + cracked_contacts(cracks, CrackMode::tensile) + "\n"), std::string::npos) << words;
    EXPECT_NE(words.find("shear cracks: " + cracked_contacts(cracks, CrackMode::shear) + "\n"), std::string::npos) << words;
}

}  // namespace
}  // namespace graincrack
