#include "mesher/import/label_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "mesher/import/labels.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/mesher/import/png_writer.hpp"

namespace graincrack::mesher {
namespace {

/// Labels of columns of a picture 10 pixels high.
std::vector<int> columns(const std::vector<int>& labels) {
    std::vector<int> samples;
    for (int row = 0; row < 10; ++row) samples.insert(samples.end(), labels.begin(), labels.end());
    return samples;
}

const std::vector<png_color> three_colours{{192, 48, 32}, {255, 255, 255}, {16, 32, 48}};

std::string palette_picture(const std::vector<png_color>& palette = three_colours) {
    const std::vector<int> labels{0, 0, 2, 0, 0, 1, 1, 1};
    return png_of(8, 10, columns(labels), {PNG_COLOR_TYPE_PALETTE, 8, false, palette});
}

std::string lines_of(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

std::vector<LabelRow> rows_of(const std::string& bytes, const PhaseKey::OfLabels& phases = {}) {
    return labels_of(bytes, {.phases = phases}, "picture.png");
}

TEST(LabelTable, HasTheColourTheAreaAndThePiecesOfEachLabel) {
    test::expect_golden(lines_of(describe_labels(rows_of(palette_picture()))));
}

TEST(LabelTable, HasTheColoursOfPicturesWithoutAPalette) {
    const auto colours = [](const std::vector<int>& samples, int type, int bits) {
        std::vector<int> found;
        for (const LabelRow& row : rows_of(png_of(2, 10, columns(samples), {type, bits}))) {
            found.push_back(row.colour.value_or(-1));
        }
        std::sort(found.begin(), found.end());
        return found;
    };
    EXPECT_EQ(colours({7, 255}, PNG_COLOR_TYPE_GRAY, 8), (std::vector<int>{0x070707, 0xffffff}));
    EXPECT_EQ(colours({1, 3}, PNG_COLOR_TYPE_GRAY, 2), (std::vector<int>{0x555555, 0xffffff}));
    EXPECT_EQ(colours({7, 255}, PNG_COLOR_TYPE_GRAY, 16), (std::vector<int>{-1, -1}));
    EXPECT_EQ(colours({192, 48, 32, 0, 0, 255}, PNG_COLOR_TYPE_RGB, 8), (std::vector<int>{0x0000ff, 0xc03020}));
    EXPECT_EQ(colours({192, 48, 32, 255, 0, 0, 255, 7}, PNG_COLOR_TYPE_RGB_ALPHA, 8), (std::vector<int>{-1, 0xc03020}));
    EXPECT_FALSE(rows_of("7 7 7 7 7 7 7 7 7 7\n").front().colour);
}

TEST(LabelTable, BecomesAKeyThatIsRead) {
    const PhaseKey::OfLabels phases{.by_colour = {{0xffffff, "feldspar"}}};
    const std::string text = key_of_labels(rows_of(palette_picture(), phases), "picture.png");
    test::expect_golden(text, "colours");
    const test::TemporaryFolder folder;
    std::ofstream(folder.file("key.tsv")) << text;
    EXPECT_EQ(PhaseKey(folder.file("key.tsv")).of_labels().by_colour, phases.by_colour);
    // Keys are numbers of greys, and where colours do not tell labels apart.
    test::expect_golden(key_of_labels(rows_of(png_of(2, 10, columns({3, 9}))), "greys.png"), "greys");
    test::expect_golden(key_of_labels(rows_of(palette_picture({{1, 2, 3}, {1, 2, 3}, {4, 5, 6}})), "twice.png"),
                        "a colour twice");
}

TEST(LabelTable, HasThePhaseOfTheNumberOrOfTheColour) {
    PhaseKey::OfLabels phases{{{0, "quartz"}, {2, "mica"}}, {{0xffffff, "feldspar"}, {0x102030, "mica"}}};
    test::expect_golden(lines_of(describe_labels(rows_of(palette_picture(), phases))));
    phases.by_number[2] = "clay";
    test::Refusals refused;
    refused.add<InputError>("one by its number, another by its colour", [&] { rows_of(palette_picture(), phases); });
    test::expect_golden(refused.text(), "refused");
}

TEST(LabelTable, ShowsTheLargestOfMany) {
    std::vector<LabelRow> rows(1234);
    for (LabelRow& row : rows) row.share_of_area = 1 / 1234.0;
    const std::vector<std::string> lines = describe_labels(rows);
    EXPECT_EQ(lines.size(), 22U);
    test::expect_golden(lines.back());
}

}  // namespace
}  // namespace graincrack::mesher
