#include "mesher/import/label_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "mesher/import/labels.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
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
    return test::png_of(8, 10, columns(labels), {PNG_COLOR_TYPE_PALETTE, 8, false, palette});
}

std::vector<LabelRow> rows_of(const std::string& bytes, const PhaseKey::OfLabels& phases = {}) {
    LabelOptions options;
    options.phases = phases;
    return labels_of(bytes, options, "picture.png");
}

TEST(LabelTable, HasTheColourTheAreaAndThePiecesOfEachLabel) {
    const std::vector<LabelRow> rows = rows_of(palette_picture());
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].label, 0);
    EXPECT_EQ(rows[0].colour, 0xc03020);
    EXPECT_EQ(rows[0].pieces, 2);
    EXPECT_DOUBLE_EQ(rows[0].share_of_area, 0.5);
    EXPECT_EQ(rows[1].label, 1);
    EXPECT_DOUBLE_EQ(rows[1].share_of_area, 0.375);
    EXPECT_EQ(rows[2].colour, 0x102030);
    EXPECT_EQ(describe_labels(rows),
              (std::vector<std::string>{
                  "       label  colour   share of area  pieces", "           0  #c03020        50.00 %       2",
                  "           1  #ffffff        37.50 %       1", "           2  #102030        12.50 %       1"}));
}

TEST(LabelTable, ColoursOfPicturesWithoutAPalette) {
    const auto colours = [](const std::vector<int>& samples, int type, int bits) {
        std::vector<int> found;
        for (const LabelRow& row : rows_of(test::png_of(2, 10, columns(samples), {type, bits}))) {
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
    PhaseKey::OfLabels phases;
    phases.by_colour[0xffffff] = "feldspar";
    const std::string text = key_of_labels(rows_of(palette_picture(), phases), "picture.png");
    EXPECT_EQ(text,
              "# Phases of the labels of picture.png: replace each ? by the name of a phase (a-z, 0-9, _)\n"
              "key\tphase\tlabel\tcolour\tshare_of_area\tpieces\n"
              "#c03020\t?\t0\t#c03020\t0.500000\t2\n"
              "#ffffff\tfeldspar\t1\t#ffffff\t0.375000\t1\n"
              "#102030\t?\t2\t#102030\t0.125000\t1\n");
    const std::string path = testing::TempDir() + "/label_table_key.tsv";
    std::ofstream(path) << text;
    EXPECT_EQ(PhaseKey(path).of_labels().by_colour, phases.by_colour);
    // Where colours do not tell labels apart, or are greys, keys are numbers.
    const std::string greys = key_of_labels(rows_of(test::png_of(2, 10, columns({3, 9}))), "greys.png");
    EXPECT_NE(greys.find("\n3\t?\t3\t#030303\t"), std::string::npos) << greys;
    const std::string twice = key_of_labels(rows_of(palette_picture({{1, 2, 3}, {1, 2, 3}, {4, 5, 6}})), "twice.png");
    EXPECT_NE(twice.find("\n1\t?\t1\t#010203\t"), std::string::npos) << twice;
}

TEST(LabelTable, APhaseIsOfTheNumberOrOfTheColour) {
    PhaseKey::OfLabels phases;
    phases.by_number = {{0, "quartz"}, {2, "mica"}};
    phases.by_colour = {{0xffffff, "feldspar"}, {0x102030, "mica"}};
    const std::vector<LabelRow> rows = rows_of(palette_picture(), phases);
    EXPECT_EQ(rows[0].phase, "quartz");
    EXPECT_EQ(rows[1].phase, "feldspar");
    EXPECT_EQ(rows[2].phase, "mica");
    EXPECT_NE(describe_labels(rows)[3].find("12.50 %       1  mica"), std::string::npos);
    phases.by_number[2] = "clay";
    graincrack::test::expect_one_line<InputError>(
        [&] { rows_of(palette_picture(), phases); },
        {"picture.png: the label 2 has the phase clay by its number and mica by its colour #102030; give one"});
}

TEST(LabelTable, ShowsTheLargestOfMany) {
    std::vector<LabelRow> rows(1234);
    for (LabelRow& row : rows) row.share_of_area = 1 / 1234.0;
    const std::vector<std::string> lines = describe_labels(rows);
    ASSERT_EQ(lines.size(), 22U);
    EXPECT_EQ(lines.back(), "  and 1214 smaller ones with 98.38 % of the area (--write-key FILE has all)");
}

}  // namespace
}  // namespace graincrack::mesher
