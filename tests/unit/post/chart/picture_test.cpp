#include "post/chart/picture.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>

#include "post/chart/font.hpp"
#include "post/command_line.hpp"
#include "post/plot/plots.hpp"
#include "post/run/run_state.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_run.hpp"

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

class Picture : public ::testing::Test {
protected:
    void SetUp() override {
        ::unsetenv("DISPLAY");
        ::unsetenv("WAYLAND_DISPLAY");
        test::write_run(path("run.h5"), recipe_);
    }
    std::string path(const std::string& name) const { return folder_.file(name); }
    Drawing cracks(const std::string& frame) const { return draw_cracks(RunReader(path("run.h5")), {frame, std::nullopt, 1}); }
    test::Recipe recipe_;
    test::TemporaryFolder folder_;
};

TEST_F(Picture, LaterShapesCoverEarlierOnesAtTheirPlace) {
    Drawing drawing(60, 40);
    drawing.rectangle({0, 0}, {30, 40}, palette::grain);
    drawing.rectangle({10, 10}, {20, 30}, palette::tensile);
    write_picture(drawing, path("shapes.png"));
    EXPECT_EQ(pixels_of(path("shapes.png"), palette::tensile), 10 * 20);
    EXPECT_EQ(pixels_of(path("shapes.png"), palette::grain), 30 * 40 - 10 * 20);
    EXPECT_EQ(pixels_of(path("shapes.png"), palette::white), 30 * 40);
}

TEST_F(Picture, CrackMapShowsRedAndBlackWithoutADisplay) {
    write_picture(cracks("last"), path("last.png"));
    write_picture(cracks("first"), path("first.png"));
    // Before any crack only the legend has them.
    EXPECT_GT(pixels_of(path("last.png"), palette::tensile), 10 * pixels_of(path("first.png"), palette::tensile));
    EXPECT_GT(pixels_of(path("last.png"), palette::shear), 10 * pixels_of(path("first.png"), palette::shear));
    EXPECT_GT(pixels_of(path("first.png"), palette::tensile), 0);
    EXPECT_GT(pixels_of(path("last.png"), palette::grain), 200000);
    EXPECT_FALSE(std::filesystem::exists(path("last.png.part")));
}

TEST_F(Picture, CrackMapCountsContactsAndNamesTheTest) {
    const std::string svg = to_svg(cracks("last"));
    std::size_t tensile = 0;
    const std::vector<Crack> all = test::synthetic_cracks(recipe_.specimen);
    for (const Crack& crack : all) tensile += crack.mode == CrackMode::tensile ? 1 : 0;
    EXPECT_NE(svg.find("tensile cracks: " + std::to_string(tensile / 2)), std::string::npos);
    EXPECT_NE(svg.find("shear cracks: " + std::to_string((all.size() - tensile) / 2)), std::string::npos);
    EXPECT_NE(svg.find("cracks: points past their peak; tensile: open, |"), std::string::npos);
    EXPECT_NE(svg.find("Uniaxial compression, Augig granite"), std::string::npos);
    EXPECT_NE(svg.find("seed 7"), std::string::npos);
    EXPECT_NE(to_svg(cracks("peak")).find("(peak)"), std::string::npos);
}

TEST_F(Picture, FramesAreChosenByWordNumberOrTime) {
    EXPECT_EQ(to_svg(cracks("peak")), to_svg(cracks("1")));
    EXPECT_EQ(to_svg(cracks("last")), to_svg(cracks("2")));
    EXPECT_EQ(to_svg(draw_cracks(RunReader(path("run.h5")), {"last", 0.9, 1})), to_svg(cracks("1")));
    EXPECT_THROW((void)cracks("3"), UsageError);
    EXPECT_THROW((void)cracks("middle"), UsageError);
}

TEST_F(Picture, MapsStandSideBySide) {
    const std::string svg = to_svg(cracks("first,peak,last"));
    for (const char* words : {"(a) before", "(b) peak", "(c) after"}) EXPECT_NE(svg.find(words), std::string::npos) << words;
    // The frame nearest to 80 % of the peak, on either side, is that of the peak here: 0, 1 and 1.25 s
    EXPECT_EQ(to_svg(cracks("before")), to_svg(cracks("1")));
    EXPECT_EQ(to_svg(cracks("after")), to_svg(cracks("1")));
    EXPECT_THROW((void)cracks("before,noon"), UsageError);
    EXPECT_THROW((void)cracks(""), UsageError);
}

TEST_F(Picture, EveryPictureHasWhatItIsAbout) {
    const RunReader run(path("run.h5"));
    const RunData data = run_data(run);
    const std::vector<Crack> all = test::synthetic_cracks(recipe_.specimen);
    const auto expect = [&](const Drawing& drawing, const std::vector<std::string>& words) {
        const std::string svg = to_svg(drawing);
        for (const std::string& each : words) EXPECT_NE(svg.find(each), std::string::npos) << each;
    };
    expect(draw_rosette(crack_rosette(all, recipe_.specimen), "title", "run.h5", "what a crack is"),
           {"tensile:", "shear:", "own facets", "what a crack is"});
    expect(draw_energy(data), {"energy balance", "largest residual 0.2 %"});
    expect(draw_thresholds(data),
           {"the third strain is taken as ε3", "axial strain by gauges, %", "crack initiation CI: not reached before the peak",
            "crack damage CD: not reached before the peak"});
    LawPlotOptions laws;
    laws.all = true;
    expect(draw_laws(data.header.contact, "granite", laws), {"literal", "consistent", "under 20 MPa"});
    EXPECT_LT(draw_laws(data.header.contact, "granite", laws).height(), 1900);
    expect(draw_lennard_jones(), {"m 12, n 18: b = 0.200"});
    expect(draw_specimen(recipe_.specimen), {"256 grains"});
    Specimen jointed = recipe_.specimen;
    jointed.flaw_names = {"joint"};
    jointed.contact_flaw.assign(jointed.n_contacts(), 0);
    jointed.contact_flaw[3] = 1;
    expect(draw_specimen(jointed), {"intact joint"});
    expect(draw_curves({data}, "what a crack is"), {"peak 124.4 MPa", "what a crack is", "plane strain"});
    expect(cracks("last"), {"tensile cracks:", "plane strain"});
    // One of the two points of a contact has failed: one micro-crack, not a half.
    test::write_run(path("odd.h5"), recipe_, {all.front()});
    expect(draw_cracks(RunReader(path("odd.h5")), {"last", std::nullopt, 1}), {"cracks: 1\n"});
    expect(cracks("first,peak,last"), {"(b) peak", "plane strain"});
    expect(cracks("peak"), {"124.4 MPa (peak)"});  // that of the curve and of tables
    EXPECT_THROW((void)draw_laws(data.header.contact, "", {{"newton"}}), UsageError);
    test::expect_one_line<InputError>([&] { (void)draw_rosette({}, "title", "run.h5", ""); }, {"run.h5", "no micro-cracks"});
}

TEST_F(Picture, NotesSayWhatSpeaksAgainstAStrength) {
    test::Recipe disc;
    disc.test = "brazilian";  // the synthetic cracks span half of the height
    test::write_run(path("disc.h5"), disc);
    const std::string line = "caveat: open cracks never span 0.8 D";
    for (const char* frame : {"last", "first,last"}) {
        const std::string map = to_svg(draw_cracks(RunReader(path("disc.h5")), {frame, std::nullopt, 1}));
        EXPECT_NE(map.find(line), std::string::npos) << frame;
    }
    EXPECT_EQ(to_svg(cracks("last")).find("caveat"), std::string::npos);
    const auto svg_of = [&](std::vector<const char*> arguments) {
        arguments.insert(arguments.begin(), "graincrack-post");
        const std::string picture = path("doubted.svg");
        arguments.insert(arguments.end(), {"-o", picture.c_str()});
        std::ostringstream out;
        run_command_line(static_cast<int>(arguments.size()), arguments.data(), out);
        return test::read_text(picture);
    };
    const std::string run = path("disc.h5");
    EXPECT_NE(svg_of({"plot", "curve", run.c_str()}).find(line), std::string::npos);
}

TEST_F(Picture, TablesAreDrawnByTheirColumns) {
    std::ofstream(path("t.tsv")) << "edge_mm\tstrength_MPa\tnote\n1\t5\ta\n2\t\tb\n4\t9\tc\n";
    const std::string svg = to_svg(draw_tables({path("t.tsv")}, {"edge_mm", {"strength_MPa"}, true}));
    EXPECT_NE(svg.find("edge, mm"), std::string::npos);
    EXPECT_NE(svg.find("strength, MPa"), std::string::npos);
    test::expect_one_line<InputError>(
        [&] {
            (void)draw_tables({path("t.tsv")}, {"edge_mm", {"weight"}, false});
        },
        {"t.tsv", "no column weight", "strength_MPa"});
    test::expect_one_line<InputError>(
        [&] {
            (void)draw_tables({path("t.tsv")}, {"edge_mm", {"note"}, false});
        },
        {"line 2", "\"a\""});
}

TEST_F(Picture, CurvesMarkTheFirstPeakIfItIsNotTheLargestStressAndTheResidualStrength) {
    recipe_.plane_young_modulus = 2.6e9;  // so that the fall lasts 1 % of strain
    test::write_run(path("soft.h5"), recipe_);
    RunData run = read_run_data(path("soft.h5"));
    const std::string falls = to_svg(draw_curves({run}, ""));
    EXPECT_NE(falls.find("first peak "), std::string::npos);
    EXPECT_EQ(falls.find("largest stress"), std::string::npos);
    EXPECT_NE(falls.find("residual strength"), std::string::npos);
    for (auto& column : run.history.columns) column.push_back(2 * column.back());
    run.history[HistoryColumn::axial_stress].back() = -200e6;
    EXPECT_NE(to_svg(draw_curves({run}, "")).find("largest stress"), std::string::npos);
    // If the stress rises again behind the fall, nothing is residual.
    RunData rises = read_run_data(path("soft.h5"));
    const LoadCurve curve = load_curve(rises);
    for (std::size_t row = 0; row < curve.stress.size(); ++row) {
        if (curve.axial_strain[row] > curve.axial_strain[curve.peak] + 0.002) {
            rises.history[HistoryColumn::axial_stress][curve.start + row] = -2 * curve.stress[curve.peak];
        }
    }
    const std::string hardens = to_svg(draw_curves({rises}, ""));
    EXPECT_NE(hardens.find("first peak"), std::string::npos);
    EXPECT_EQ(hardens.find("residual strength"), std::string::npos);
}

TEST_F(Picture, CurvesOfSeveralMaterialsNameThem) {
    std::vector<RunData> runs(2, read_run_data(path("run.h5")));
    runs[1].header.material = "Gabbro";
    const std::string words = draw_curves(runs, "").words();
    EXPECT_NE(words.find("Stress and strain"), std::string::npos) << words;
    for (const RunData& run : runs) EXPECT_NE(words.find("uniaxial, " + run.header.material + ":"), std::string::npos) << words;
}

TEST_F(Picture, EnvelopeShowsCirclesAndBothCurves) {
    EnvelopeTests tests;
    for (double s : {0.0, 4e6, 8e6}) tests.compression.push_back({s, 120e6 + 9 * s, 1});
    tests.brazilian = {8e6};
    const std::string svg = to_svg(draw_envelope(tests, "rock"));
    for (const char* words : {"σ3 = 4 MPa", "Mohr–Coulomb", "Hoek–Brown", "centre of the disc", "φ = 53.1"}) {
        EXPECT_NE(svg.find(words), std::string::npos) << words;  // sin φ = 8/10
    }
    EXPECT_NE(svg.find("σ1 is the largest stress of a test"), std::string::npos);
    tests.kind = StrengthKind::first_peak;
    tests.compression_runs = 4;
    EXPECT_NE(to_svg(draw_envelope(tests, "rock")).find("σ1 is the first peak of a test; 3 of 4 tests have one"),
              std::string::npos);
    EnvelopeTests two;
    two.compression = {tests.compression[0], tests.compression[2]};
    const std::string head = draw_envelope(two, "rock").words();
    EXPECT_NE(head.find("C and φ: not determined by 2 tests"), std::string::npos) << head;
    EXPECT_EQ(head.find("mi "), std::string::npos) << head;
    for (auto& test : tests.compression) test.strength = 200e6 - 9 * test.confining;
    EXPECT_NE(to_svg(draw_envelope(tests, "rock")).find("no Mohr–Coulomb line"), std::string::npos);
    for (auto& test : tests.compression) test.strength = 120e6 + 9 * test.confining;
    write_picture(draw_envelope(tests, "rock"), path("envelope.png"));
    EXPECT_GT(pixels_of(path("envelope.png"), palette::series(0)), 500);
}

TEST_F(Picture, CurvesOfDifferentTestsDoNotShareAPlot) {
    test::Recipe other;
    other.test = "brazilian";
    other.peak = 8e6;
    test::write_run(path("brazilian.h5"), other);
    EXPECT_THROW((void)draw_curves({read_run_data(path("run.h5")), read_run_data(path("brazilian.h5"))}, ""), InputError);
}

TEST_F(Picture, AWidthOnPaperSetsPixelsOfAPngAndPointsOfSvgAndPdf) {
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
    std::ifstream file(path("column.pdf"), std::ios::binary);
    const std::string pdf((std::istreambuf_iterator<char>(file)), {});
    EXPECT_TRUE(pdf.starts_with("%PDF-"));
    EXPECT_NE(pdf.find("/MediaBox [ 0 0 144 72 ]"), std::string::npos);
    EXPECT_NE(pdf.find("LiberationSans"), std::string::npos) << "the font is not in the file";
    write_picture(drawing, path("again.pdf"), {0.0508, std::nullopt});
    std::ifstream other(path("again.pdf"), std::ios::binary);
    EXPECT_EQ(pdf, std::string((std::istreambuf_iterator<char>(other)), {}));
}

TEST_F(Picture, APngOfAWidthSaysItsResolution) {
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

TEST_F(Picture, AResolutionThatMeansNothingIsRefused) {
    test::expect_one_line<UsageError>([&] { require_picture("a.svg", {0.08, 300}); }, {"--dpi", "a.svg"});
    test::expect_one_line<UsageError>([&] { require_picture("a.png", {std::nullopt, 300}); }, {"--dpi", "--width 84mm"});
    test::expect_one_line<OutputError>([&] { (void)png_bytes(Drawing(100, 100), {2, 2400}); }, {"188976", "--dpi"});
}

TEST_F(Picture, NamesAndPlacesThatCannotBeAreOneError) {
    const Drawing drawing(10, 10);
    EXPECT_THROW(write_picture(drawing, path("picture.jpg")), UsageError);
    EXPECT_THROW(write_picture(drawing, path("no/such/folder.png")), OutputError);
    EXPECT_THROW(write_picture(drawing, path("no/such/folder.svg")), OutputError);
}

TEST_F(Picture, ManyGrainsAreNoLargerThanTheirPage) {
    const Drawing drawing = draw_specimen(test::grid_specimen(300, 300, 0.08, 0.08));  // edges of 3 pixels
    EXPECT_LT(drawing.n_marks(), 4000U);  // 944 rows, 1,200 edges of the rim, legend and title
    write_picture(drawing, path("many.png"));
    EXPECT_GT(pixels_of(path("many.png"), palette::grain), 930 * 930);  // the page without its margins and the rim
    EXPECT_GT(draw_specimen(test::grid_specimen(30, 30, 0.08, 0.08)).n_marks(), 1800U);  // each grain and outline
}

}  // namespace
}  // namespace graincrack
