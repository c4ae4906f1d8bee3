// Pictures of a film of a run with known answers.
#include "post/film/film_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "post/chart/font.hpp"
#include "post/chart/map_view.hpp"
#include "post/film/film.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/drawing_shapes.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

TEST(FilmRows, AreEvenStepsOfWhatTheStrainTravels) {
    const std::vector<double> loading{0, -0.001, -0.002, -0.003, -0.005, -0.007, -0.009};  // twice as fast in the second half
    EXPECT_EQ(film_rows(loading, 0, 6, 4), (std::vector<std::size_t>{0, 3, 4, 6}));
    EXPECT_EQ(film_rows(loading, 1, 3, 3), (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_EQ(film_rows({0, 2, 1, 2}, 0, 3, 5), (std::vector<std::size_t>{0, 0, 1, 2, 3}));  // unloading counts as loading
    EXPECT_EQ(film_rows({0, 1, 1, 2}, 0, 3, 3), (std::vector<std::size_t>{0, 2, 3}));        // rest is left out
}

TEST(FilmRows, OfCracksAreShortBeforeTheFirst) {
    History history;
    for (std::vector<double>& column : history.columns) column.assign(9, 0);
    history[HistoryColumn::axial_strain] = {0, -0.001, -0.002, -0.003, -0.004, -0.004, -0.004, -0.004, -0.004};
    history[HistoryColumn::tensile_cracks] = {0, 0, 0, 0, 0, 3, 3, 6, 6};
    history[HistoryColumn::shear_cracks] = {0, 0, 0, 0, 0, 0, 3, 3, 6};
    EXPECT_EQ(film_rows(film_way(FilmSteps::cracks, history), 0, 8, 5), (std::vector<std::size_t>{0, 4, 5, 6, 8}));
    EXPECT_EQ(film_rows(film_way(FilmSteps::strain, history), 0, 8, 5), (std::vector<std::size_t>{0, 1, 2, 3, 8}));
    for (const HistoryColumn mode : {HistoryColumn::tensile_cracks, HistoryColumn::shear_cracks}) history[mode].assign(9, 0);
    EXPECT_EQ(film_rows(film_way(FilmSteps::cracks, history), 0, 8, 5), (std::vector<std::size_t>{0, 1, 2, 3, 8}));
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

/// The last row of the history of a run that is not behind a time.
std::size_t row_at(const RunReader& run, double time) {
    const std::vector<double> times = run.history()[HistoryColumn::time];
    return static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time + 1e-12) - times.begin()) - 1;
}

/// The position of the point on the stress–strain curve.
Pixel point_on_curve(const Drawing& drawing) { return test::lines_of(drawing, palette::series(0), 22).at(0).points.front(); }

TEST_F(Film, ShowsCracksFromTheirTimeOn) {
    const RunReader run(path("run.h5"));
    FilmPage page(run, {});
    EXPECT_EQ(strokes_of(page.at(row_at(run, 0.4)), palette::tensile), 0U);
    const std::vector<Crack> cracks = test::synthetic_cracks(recipe_.specimen);
    const std::size_t row = row_at(run, cracks[cracks.size() / 2].time);
    const double half = run.history()[HistoryColumn::time][row];
    std::size_t tensile = 0;
    for (const Crack& crack : cracks) tensile += crack.time <= half && crack.mode_angle < 0.7 ? 1U : 0U;
    EXPECT_GT(tensile, 0U);
    EXPECT_EQ(strokes_of(page.at(row), palette::tensile), tensile);
    EXPECT_GT(strokes_of(page.at(row_at(run, 1.25)), palette::tensile), tensile);
}

TEST_F(Film, ThePointMovesAlongTheCurveAndAllElseStays) {
    const RunReader run(path("run.h5"));
    FilmContents contents;
    contents.steps = FilmSteps::strain;
    FilmPage page(run, contents);
    const std::vector<std::size_t> rows = page.rows(5);
    EXPECT_EQ(rows.front(), 0U);
    EXPECT_EQ(rows.back(), row_at(run, 1.25));
    const Drawing first = page.at(rows[0]);
    const Drawing second = page.at(rows[1]);
    const Drawing last = page.at(rows[4]);
    EXPECT_LT(point_on_curve(first).x, point_on_curve(second).x);
    EXPECT_GT(point_on_curve(first).y, point_on_curve(second).y);
    const double whole = point_on_curve(last).x - point_on_curve(first).x;
    EXPECT_NEAR(point_on_curve(second).x - point_on_curve(first).x, whole / 4, whole / 20);  // a row of the history
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
        const Drawing drawing = page.at(row_at(run, 1));
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
    const std::string words = FilmPage(run, {}).at(row_at(run, 1.25)).words();
    EXPECT_NE(words.find("tensile cracks: " + cracked_contacts(cracks, CrackMode::tensile) + "\n"), std::string::npos) << words;
    EXPECT_NE(words.find("shear cracks: " + cracked_contacts(cracks, CrackMode::shear) + "\n"), std::string::npos) << words;
}

}  // namespace
}  // namespace graincrack
