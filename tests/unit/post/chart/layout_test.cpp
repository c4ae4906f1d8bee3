// Pages as they are printed, in a column and over two: no text covers another or is cut, letters can be read.
#include <gtest/gtest.h>

#include <fstream>

#include "post/chart/font.hpp"
#include "post/chart/page.hpp"
#include "post/plot/plots.hpp"
#include "tests/support/drawing_shapes.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

class Layout : public test::RunFolder, public ::testing::WithParamInterface<double> {
protected:
    void SetUp() override {
        style_.page_width = page_width_on_paper(GetParam());
        run("run.h5", recipe_);
    }
    RunData run_of(const std::string& test, double peak, double confining, const std::string& name) const {
        const PlaneCondition plane = test == "brazilian" ? PlaneCondition::stress : PlaneCondition::strain;
        return read_run_data(run(name, {.test = test, .plane = plane, .confining_pressure = confining, .peak = peak}));
    }
    void expect_fit_to_print(const Drawing& drawing, const std::string& what) const {
        const std::vector<Text> texts = test::texts_of(drawing);
        const double points = GetParam() / 0.0254 * 72 / drawing.width();
        EXPECT_EQ(drawing.width(), static_cast<int>(style_.page_width)) << what;
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const TextBox box = box_of(texts[i]);
            EXPECT_TRUE(box.left >= 0 && box.top >= 0 && box.right <= drawing.width() && box.bottom <= drawing.height())
                << what << ": \"" << texts[i].label << "\" is cut";
            EXPECT_GE(texts[i].size * points, 6) << what << ": " << texts[i].label;
            EXPECT_LE(texts[i].size * points, 10) << what << ": " << texts[i].label;
            for (std::size_t k = 0; k < i; ++k) {
                EXPECT_FALSE(box.overlaps(box_of(texts[k])))
                    << what << ": \"" << texts[i].label << "\" covers \"" << texts[k].label << "\"";
            }
        }
    }
    test::Recipe recipe_;
    PictureStyle style_;
};

INSTANTIATE_TEST_SUITE_P(Widths, Layout, ::testing::Values(0.084, 0.174));

TEST_P(Layout, FitsPicturesOfOneRun) {
    const RunReader run(path("run.h5"));
    const RunData data = run_data(run);
    const std::vector<Crack> all = test::synthetic_cracks(recipe_.specimen);
    const std::string definition = definition_of({});
    expect_fit_to_print(draw_specimen(recipe_.specimen, style_), "specimen");
    expect_fit_to_print(draw_curves({data}, definition, {}, style_), "curve");
    expect_fit_to_print(draw_cracks(run, {"last", std::nullopt, 1}, style_), "cracks");
    expect_fit_to_print(draw_cracks(run, {"first,peak,last", std::nullopt, 1}, style_), "maps");
    expect_fit_to_print(draw_rosette(crack_rosette(all, recipe_.specimen), "Uniaxial compression", "run.h5", definition, style_),
                        "rosette");
    expect_fit_to_print(draw_energy(data, style_), "energy");
    expect_fit_to_print(draw_thresholds(data, style_), "thresholds");
    RunData opening = data;
    test::widen(opening.history, recipe_, 4e-7);
    expect_fit_to_print(draw_thresholds(opening, style_), "thresholds that are reached");
    LawPlotOptions laws;
    expect_fit_to_print(draw_laws(data.header.contact, "Augig granite, plane strain", laws, style_), "law");
    laws.all = true;
    expect_fit_to_print(draw_laws(data.header.contact, "Augig granite, plane strain", laws, style_), "laws");
    expect_fit_to_print(draw_lennard_jones(style_), "lennard-jones");
}

TEST_P(Layout, FitsPicturesOfSeveralRuns) {
    const std::vector<RunData> runs{run_of("brazilian", 9e6, 0, "b.h5"), run_of("uniaxial", 120e6, 0, "u.h5"),
                                    run_of("triaxial", 150e6, 4e6, "t4.h5"), run_of("triaxial", 180e6, 8e6, "t8.h5"),
                                    run_of("uniaxial", 125e6, 0, "a-long-name-of-a-file-with-words-that-never-end-and-end.h5")};
    expect_fit_to_print(draw_curves({runs[1], runs[2], runs[3], runs[4]}, "", {"σ3 = 4 MPa: did not fail (1 of 1 run)"}, style_),
                        "curves");
    EnvelopeTests tests;
    for (const double s : {0.0, 4e6, 8e6}) tests.compression.push_back({s, 120e6 + 9 * s, 1});
    tests.brazilian = {8e6};
    tests.direct_tension = {7e6};
    expect_fit_to_print(draw_envelope(tests, "Augig granite", style_), "envelope");
    std::vector<RunData> coarse{runs[0], runs[1]};
    for (RunData& run : coarse) run.specimen.mean_edge *= 2;
    const auto sizes = collect_sizes({runs[0], runs[1], coarse[0], coarse[1]},
                                     {.strain_limit_runs = StrainLimitRuns::accept, .strength = StrengthKind::largest});
    expect_fit_to_print(draw_size_effect(sizes, style_), "size effect");
}

TEST_P(Layout, FitsPicturesOfTables) {
    std::ofstream(path("small.tsv"))
        << "time_s\topening_m\tsliding_m\n1e-5\t1e-14\t3e-13\n2e-5\t2e-14\t4e-13\n3e-5\t2e-14\t4.5e-13\n";
    expect_fit_to_print(draw_tables({path("small.tsv")}, {"time_s", {"opening_m", "sliding_m"}, false}, style_), "table");
    ccd::SolveOptions problem;
    problem.goals.targets = {"C_MPa=21", "phi_deg=53"};
    const ccd::Problem solved = ccd::solve_problem(std::string(GRAINCRACK_SOURCE) + "/tests/data/table7.csv", problem);
    expect_fit_to_print(draw_surface(solved, style_), "surface");
}

TEST_P(Layout, BreaksALongTitleIntoLines) {
    style_.title =
        "A title that somebody gave, with many words, and then some more, so that no page is wide enough for all of them, "
        "however small its letters are";
    const RunReader run(path("run.h5"));
    expect_fit_to_print(draw_cracks(run, {"first,peak,last", std::nullopt, 1}, style_), "maps");
    expect_fit_to_print(draw_cracks(run, {"last", std::nullopt, 1}, style_), "map");
    expect_fit_to_print(draw_energy(run_data(run), style_), "energy");
    expect_fit_to_print(draw_lennard_jones(style_), "lennard-jones");
}

}  // namespace
}  // namespace graincrack
