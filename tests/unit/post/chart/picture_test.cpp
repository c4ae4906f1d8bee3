#include "post/chart/picture.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>

#include "post/command_line.hpp"
#include "post/plot/plots.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

using Image = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
Image read_png(const std::string& path) { return {cairo_image_surface_create_from_png(path.c_str()), &cairo_surface_destroy}; }

/// Pixels of exactly one colour in a PNG.
int pixels_of(const std::string& path, Colour colour) {
    const Image image = read_png(path);
    const int stride = cairo_image_surface_get_stride(image.get());
    int count = 0;
    for (int y = 0; y < cairo_image_surface_get_height(image.get()); ++y) {
        for (int x = 0; x < cairo_image_surface_get_width(image.get()); ++x) {
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, cairo_image_surface_get_data(image.get()) + y * stride + 4 * x, sizeof pixel);
            if ((pixel & 0xFFFFFFU) == (colour.red * 65536U + colour.green * 256U + colour.blue)) ++count;
        }
    }
    return count;
}

class Picture : public test::RunFolder {
protected:
    void SetUp() override {
        ::unsetenv("DISPLAY");
        ::unsetenv("WAYLAND_DISPLAY");
        test::write_run(path("run.h5"), recipe_);
    }
    Drawing cracks(const std::string& frame, const std::string& run = "run.h5") const {
        return draw_cracks(RunReader(path(run)), {frame, std::nullopt, 1});
    }
    /// The texts of the picture that `plot` with some words draws.
    std::string plotted(std::vector<std::string> words) const {
        words.insert(words.begin(), {"graincrack-post", "plot"});
        words.insert(words.end(), {"-o", path("picture.svg")});
        std::vector<const char*> arguments;
        for (const std::string& word : words) arguments.push_back(word.c_str());
        std::ostringstream out;
        run_command_line(static_cast<int>(arguments.size()), arguments.data(), out);
        const std::string svg = test::read_text(path("picture.svg"));
        return svg.substr(0, svg.find("</desc>")).substr(svg.find("<desc>") + 6);
    }
    test::Recipe recipe_;
    test::GoldenRefusals refused_{"refused"};
};

TEST_F(Picture, CoversEarlierShapesByLaterOnesAtTheirPlace) {
    Drawing drawing(60, 40);
    drawing.rectangle({0, 0}, {30, 40}, palette::grain);
    drawing.rectangle({10, 10}, {20, 30}, palette::tensile);
    write_picture(drawing, path("shapes.png"));
    EXPECT_EQ(pixels_of(path("shapes.png"), palette::tensile), 10 * 20);
    EXPECT_EQ(pixels_of(path("shapes.png"), palette::grain), 30 * 40 - 10 * 20);
    EXPECT_EQ(pixels_of(path("shapes.png"), palette::white), 30 * 40);
}

TEST_F(Picture, HasCracksInRedAndBlackWithoutADisplay) {
    write_picture(cracks("last"), path("last.png"));
    write_picture(cracks("first"), path("first.png"));
    // Before any crack only the legend has them.
    EXPECT_GT(pixels_of(path("last.png"), palette::tensile), 10 * pixels_of(path("first.png"), palette::tensile));
    EXPECT_GT(pixels_of(path("last.png"), palette::shear), 10 * pixels_of(path("first.png"), palette::shear));
    EXPECT_GT(pixels_of(path("first.png"), palette::tensile), 0);
    EXPECT_GT(pixels_of(path("last.png"), palette::grain), 200000);
    EXPECT_FALSE(std::filesystem::exists(path("last.png.part")));
}

TEST_F(Picture, IsOfFramesByWordNumberOrTime) {
    // The frame nearest to 80 % of the peak, on either side, is that of the peak here: 0, 1 and 1.25 s
    for (const char* const frame : {"peak", "before", "after"}) EXPECT_EQ(to_svg(cracks(frame)), to_svg(cracks("1"))) << frame;
    EXPECT_EQ(to_svg(cracks("last")), to_svg(cracks("2")));
    EXPECT_EQ(to_svg(draw_cracks(RunReader(path("run.h5")), {"last", 0.9, 1})), to_svg(cracks("1")));
    refused_.add_each<UsageError>({"3", "middle", "before,noon", ""}, [&](const char* frame) { (void)cracks(frame); });
}

TEST_F(Picture, SaysWhatItIsAbout) {
    const RunData data = read_run_data(path("run.h5"));
    const std::vector<Crack> all = test::synthetic_cracks(recipe_.specimen);
    Specimen jointed = recipe_.specimen;
    jointed.flaw_names = {"joint"};
    jointed.contact_flaw.assign(jointed.n_contacts(), 0);
    jointed.contact_flaw[3] = 1;
    test::write_run(path("odd.h5"), recipe_, {all.front()});
    const std::vector<std::pair<const char*, Drawing>> pictures{
        {"rosette", draw_rosette(crack_rosette(all, recipe_.specimen), "title", "run.h5", "what a crack is")},
        {"thresholds", draw_thresholds(data)},
        {"lennard-jones", draw_lennard_jones()},
        {"specimen", draw_specimen(recipe_.specimen)},
        {"specimen with a joint", draw_specimen(jointed)},
        {"curve", draw_curves({data}, "what a crack is")},
        {"cracks", cracks("last")},
        {"cracks of one point of a contact", cracks("last", "odd.h5")},
        {"cracks side by side", cracks("first,peak,last")},
        {"cracks at the peak", cracks("peak")}};
    for (const auto& [name, picture] : pictures) test::expect_golden(picture.words(), name);
    refused_.add<UsageError>("a law", [&] { (void)draw_laws(data.header.contact, "", {{"newton"}}); });
    refused_.add<InputError>("no cracks", [&] { (void)draw_rosette({}, "title", "run.h5", ""); });
}

TEST_F(Picture, NotesWhatSpeaksAgainstAStrength) {
    test::write_run(path("disc.h5"), {.test = "brazilian"});  // the synthetic cracks span half of the height
    test::expect_golden(cracks("last", "disc.h5").words(), "one map");
    test::expect_golden(cracks("first,last", "disc.h5").words(), "two maps");
    test::expect_golden(plotted({"curve", path("disc.h5")}), "curve");
}

TEST_F(Picture, TakesATitleLabelsAndLimits) {
    const std::string run = path("run.h5"), title = "My own words";
    for (const char* const plot :
         {"specimen", "curve", "cracks", "cracks --frame first,last", "rosette", "energy", "thresholds", "law"}) {
        const auto parts = split(plot, ' ');
        std::vector<std::string> words(parts.begin(), parts.end());
        words.insert(words.end(), {run, "--title", title});
        EXPECT_NE(plotted(words).find(title), std::string::npos) << plot;
    }
    test::expect_golden(plotted({"curve", run, "--label", "run.h5=dry", "--x-limits", "-0.1,0.2", "--y-limits", "0,500"}));
    refused_.add<UsageError>("a label", [&] { plotted({"curve", run, "--label", "wet.h5=wet"}); });
    refused_.add<UsageError>("limits", [&] { plotted({"energy", run, "--x-limits", "1e6,2e6"}); });
}

TEST_F(Picture, IsOfTheColumnsOfATable) {
    std::ofstream(path("t.tsv")) << "edge_mm\tstrength_MPa\tnote\n1\t5\ta\n2\t\tb\n4\t9\tc\n";
    const auto draw = [&](const char* column) { return draw_tables({path("t.tsv")}, {"edge_mm", {column}, true}); };
    test::expect_golden(draw("strength_MPa").words());
    refused_.add_each<InputError>({"weight", "note"}, draw);
}

TEST_F(Picture, MarksTheFirstPeakIfItIsNotTheLargestStressAndTheResidualStrength) {
    test::write_run(path("soft.h5"), {.plane_young_modulus = 2.6e9});  // so that the fall lasts 1 % of strain
    const RunData soft = read_run_data(path("soft.h5"));
    test::expect_golden(draw_curves({soft}, "").words(), "falls");
    RunData run = soft;
    for (auto& column : run.history.columns) column.push_back(2 * column.back());
    run.history[HistoryColumn::axial_stress].back() = -200e6;
    test::expect_golden(draw_curves({run}, "").words(), "rises beyond");
    // If the stress rises again behind the fall, nothing is residual.
    run = soft;
    const LoadCurve curve = load_curve(run);
    for (std::size_t row = 0; row < curve.stress.size(); ++row) {
        if (curve.axial_strain[row] > curve.axial_strain[curve.peak] + 0.002) {
            run.history[HistoryColumn::axial_stress][curve.start + row] = -2 * curve.stress[curve.peak];
        }
    }
    test::expect_golden(draw_curves({run}, "").words(), "hardens");
}

TEST_F(Picture, NamesSeveralMaterialsAndHasTestsOfOneKind) {
    std::vector<RunData> runs(2, read_run_data(path("run.h5")));
    runs[1].header.material = "Gabbro";
    test::expect_golden(draw_curves(runs, "").words());
    test::write_run(path("brazilian.h5"), {.test = "brazilian", .peak = 8e6});
    runs[1] = read_run_data(path("brazilian.h5"));
    refused_.add<InputError>("another test", [&] { (void)draw_curves(runs, ""); });
}

TEST_F(Picture, HasCirclesAndBothCurvesOfAnEnvelope) {
    EnvelopeTests tests;
    for (double s : {0.0, 4e6, 8e6}) tests.compression.push_back({s, 120e6 + 9 * s, 1});  // sin φ = 8/10
    tests.brazilian = {8e6};
    test::expect_golden(draw_envelope(tests, "rock").words());
    write_picture(draw_envelope(tests, "rock"), path("envelope.png"));
    EXPECT_GT(pixels_of(path("envelope.png"), palette::series(0)), 500);
    EnvelopeTests two;
    two.compression = {tests.compression[0], tests.compression[2]};
    test::expect_golden(draw_envelope(two, "rock").words(), "of two tests");
    tests.kind = StrengthKind::first_peak;
    tests.compression_runs = 4;
    test::expect_golden(draw_envelope(tests, "rock").words(), "of first peaks");
    for (auto& test : tests.compression) test.strength = 200e6 - 9 * test.confining;
    test::expect_golden(draw_envelope(tests, "rock").words(), "of strengths that fall");
}

TEST_F(Picture, HasTheWidthOnPaperInPixelsOfPngAndPointsOfSvgAndPdf) {
    Drawing drawing(1000, 500);
    drawing.rectangle({0, 0}, {500, 500}, palette::grain);
    drawing.text({{500, 250}, "σ1 < 3 & φ"});
    write_picture(drawing, path("column.png"), {0.0508, 600});
    const Image image = read_png(path("column.png"));
    EXPECT_EQ(cairo_image_surface_get_width(image.get()), 1200);
    EXPECT_EQ(cairo_image_surface_get_height(image.get()), 600);
    EXPECT_EQ(pixels_of(path("column.png"), palette::grain), 600 * 600);
    const std::string svg = to_svg(drawing, {0.0508, std::nullopt});
    EXPECT_NE(svg.find("width=\"144pt\" height=\"72pt\""), std::string::npos) << svg.substr(0, 300);
    EXPECT_NE(svg.find("<desc>σ1 &lt; 3 &amp; φ\n</desc>"), std::string::npos) << svg.substr(0, 500);
    write_picture(drawing, path("column.pdf"), {0.0508, std::nullopt});
    const std::string pdf = test::read_text(path("column.pdf"));
    EXPECT_TRUE(pdf.starts_with("%PDF-"));
    EXPECT_NE(pdf.find("/MediaBox [ 0 0 144 72 ]"), std::string::npos);
    EXPECT_NE(pdf.find("LiberationSans"), std::string::npos) << "the font is not in the file";
    write_picture(drawing, path("again.pdf"), {0.0508, std::nullopt});
    EXPECT_EQ(pdf, test::read_text(path("again.pdf")));
}

TEST_F(Picture, HasItsResolutionInAPngOfAWidth) {
    const Drawing drawing(100, 50);
    EXPECT_EQ(png_bytes(drawing), png_bytes(drawing));
    const std::vector<unsigned char> without = png_bytes(drawing);
    const std::vector<unsigned char> png = png_bytes(drawing, {100 * 0.0254 / 300, 300});  // of 100 pixels too
    // Behind the signature and IHDR: 9 bytes of data, 300 dpi = 11811 = 0x2e23 pixels a metre, twice, unit 1, the chunk's CRC.
    const std::vector<unsigned char> chunk{0,    0, 0, 9,    'p',  'H', 'Y',  's',  0,    0,   0x2e,
                                           0x23, 0, 0, 0x2e, 0x23, 1,   0x78, 0xa5, 0x3f, 0x76};
    ASSERT_EQ(png.size(), without.size() + chunk.size());
    EXPECT_TRUE(std::equal(chunk.begin(), chunk.end(), png.begin() + 33));
    EXPECT_TRUE(std::equal(without.begin(), without.begin() + 33, png.begin()));
    EXPECT_TRUE(std::equal(without.begin() + 33, without.end(), png.begin() + 33 + std::ssize(chunk)));
    write_picture(drawing, path("sized.png"), {100 * 0.0254 / 300, 300});
    EXPECT_EQ(cairo_image_surface_get_width(read_png(path("sized.png")).get()), 100);
}

TEST_F(Picture, NeedsAResolutionANameAndAPlaceThatCanBe) {
    const Drawing drawing(100, 100);
    refused_.add<UsageError>("dpi of SVG", [] { require_picture("a.svg", {0.08, 300}); });
    refused_.add<UsageError>("dpi without a width", [] { require_picture("a.png", {std::nullopt, 300}); });
    refused_.add<OutputError>("too many pixels", [&] { (void)png_bytes(drawing, {2, 2400}); });
    refused_.add<UsageError>("another format", [&] { write_picture(drawing, path("picture.jpg")); });
    for (const char* const name : {"no/such/folder.png", "no/such/folder.svg"}) {
        refused_.add<OutputError>("no folder", [&] { write_picture(drawing, path(name)); });
    }
}

TEST_F(Picture, HasFewMarksOfGrainsTooSmallForItsPage) {
    const Drawing drawing = draw_specimen(test::grid_specimen(300, 300, 0.08, 0.08));  // edges of 3 pixels
    EXPECT_LT(drawing.n_marks(), 4000U);  // 944 rows, 1,200 edges of the rim, legend and title
    write_picture(drawing, path("many.png"));
    EXPECT_GT(pixels_of(path("many.png"), palette::grain), 930 * 930);  // the page without its margins and the rim
    EXPECT_GT(draw_specimen(test::grid_specimen(30, 30, 0.08, 0.08)).n_marks(), 1800U);  // each grain and outline
}

}  // namespace
}  // namespace graincrack
