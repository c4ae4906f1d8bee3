#include "post/chart/picture_style.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "post/chart/chart.hpp"
#include "post/command_line.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

TEST(PictureStyle, LimitsAreTwoNumbersInTheUnitOfTheAxis) {
    const AxisLimits limits = parse_limits("-0.2, 0.4", "--x-limits");
    EXPECT_DOUBLE_EQ(limits.low, -0.2);
    EXPECT_DOUBLE_EQ(limits.high, 0.4);
    for (const char* wrong : {"0.4", "0,", "a,b", "0,inf", "0,4mm"}) {
        test::expect_one_line<UsageError>([&] { (void)parse_limits(wrong, "--x-limits"); }, {"--x-limits", wrong, "0,0.4 fits"});
    }
    test::expect_one_line<UsageError>([&] { (void)parse_limits("0.4,0.4", "--y-limits"); }, {"--y-limits 0.4,0.4", "below"});
    const Axis strain{"strain, % (lateral left, axial right)", -1, 1};
    EXPECT_EQ(strain.unit(), "%");
    EXPECT_DOUBLE_EQ(strain.limited(limits).high, 0.4);
    test::expect_one_line<UsageError>(
        [&] {
            (void)Axis({"n", 1, 9, true}).limited(parse_limits("0,4", "--y-limits"));
        },
        {"logarithmic", "above 0"});
}

TEST(PictureStyle, LimitsThatShowNothingAreRefused) {
    const auto draw = [](const std::string& limits) {
        PictureStyle style;
        style.x_limits = parse_limits(limits, "--x-limits");
        Chart chart(style, {}, {"x, mm", 0, 1}, {"y", 0, 1});
        chart.line(std::vector<double>{0, 1}, std::vector<double>{0, 1}, Stroke{});
        (void)chart.finish();
    };
    EXPECT_NO_THROW(draw("0.5,3"));
    test::expect_one_line<UsageError>([&] { draw("5,6"); }, {"--x-limits 5,6", "nothing lies there", "0,1"});
}

TEST(PictureStyle, ALabelNamesAFileOfThePicture) {
    PictureStyle style;
    style.labels = {parse_run_label("uniaxial=dry, fast"), parse_run_label("runs/wet.h5=wet = slow")};
    EXPECT_EQ(style.label_of("runs/uniaxial.h5"), "dry, fast");
    EXPECT_EQ(style.label_of("runs/wet.h5"), "wet = slow");
    EXPECT_EQ(style.label_of("other.h5"), "");
    test::expect_one_line<UsageError>(
        [&] {
            style.require_labels_of({"uniaxial.h5", "dry.h5"});
        },
        {"--label runs/wet.h5", "uniaxial.h5, dry.h5"});
    for (const char* wrong : {"uniaxial.h5", "=dry", "uniaxial.h5="}) {
        test::expect_one_line<UsageError>([&] { (void)parse_run_label(wrong); }, {"--label", wrong});
    }
}

TEST(PictureStyle, LettersGrowLessThanThePicture) {
    const auto points = [](double width) { return letters::text * width / 0.0254 * 72 / page_width_on_paper(width); };
    EXPECT_GE(points(0.06), 6);
    EXPECT_GE(points(0.084), 6);
    EXPECT_LT(points(0.084), 7);
    EXPECT_GT(points(0.174), 7.5);
    EXPECT_LT(points(0.174), 9);
}

TEST(PictureStyle, EveryPictureTakesTheOptions) {
    const test::TemporaryFolder folder;
    const std::string run = folder.file("run.h5");
    test::write_run(run, {});
    const auto svg_of = [&](std::vector<std::string> words) {
        const std::string picture = folder.file("picture.svg");
        words.insert(words.begin(), {"graincrack-post", "plot"});
        words.insert(words.end(), {"-o", picture});
        std::vector<const char*> arguments;
        for (const std::string& word : words) arguments.push_back(word.c_str());
        std::ostringstream out;
        run_command_line(static_cast<int>(arguments.size()), arguments.data(), out);
        return test::read_text(picture);
    };
    for (const char* plot :
         {"specimen", "curve", "strength", "cracks", "fragments", "rosette", "counts", "energy", "thresholds"}) {
        EXPECT_NE(svg_of({plot, run, "--title", "My own words"}).find("My own words"), std::string::npos) << plot;
    }
    EXPECT_NE(svg_of({"cracks", run, "--frame", "first,last", "--title", "My own words"}).find("My own words"),
              std::string::npos);
    EXPECT_NE(svg_of({"law", run, "--title", "My own words"}).find("My own words"), std::string::npos);
    EXPECT_NE(svg_of({"curve", run, "--label", "run.h5=dry"}).find("dry\n"), std::string::npos);
    EXPECT_NE(svg_of({"curve", run, "--x-limits", "-0.1,0.2", "--y-limits", "0,500"}).find("\n500\n"), std::string::npos);
    test::expect_one_line<UsageError>([&] { (void)svg_of({"curve", run, "--label", "wet.h5=wet"}); }, {"wet.h5", "run.h5"});
    test::expect_one_line<UsageError>(
        [&] {
            (void)svg_of({"energy", run, "--x", "strain", "--x-limits", "90,91"});
        },
        {"--x-limits 90,91"});
}

}  // namespace
}  // namespace graincrack
