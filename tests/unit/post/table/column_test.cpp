// A table as a list of columns: every form shows the same values in their units.
#include "post/table/column.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace graincrack {
namespace {

struct Trial {
    std::string name;
    std::optional<double> strength;  // Pa
    int seed = 0;
};

const Columns<Trial> columns{{"test", unit::none, [](const Trial& t) { return t.name; }},
                             {"tensile_strength", unit::megapascal, [](const Trial& t) { return t.strength; }},
                             {"seed", unit::none, [](const Trial& t) { return t.seed; }}};
const std::vector<Trial> tests{{"a", 12.345678912e6, 1}, {"b", std::nullopt, 20000000}, {"a", 1e6, 3}};

TEST(Column, UnitsEndNamesAndScaleRealsOnly) {
    std::ostringstream out;
    write_table(out, columns, tests, TableFormat::tsv);
    EXPECT_EQ(out.str(), "test\ttensile_strength_MPa\tseed\na\t12.34568\t1\nb\t\t20000000\na\t1\t3\n");
}

TEST(Column, EmptyCellsAreThoseWithoutAValue) {
    EXPECT_TRUE(Cell(std::optional<double>()).empty());
    EXPECT_TRUE(Cell(std::nan("")).empty());
    EXPECT_TRUE(Cell("").empty());
    EXPECT_FALSE(Cell(0.0).empty());
    EXPECT_EQ(Cell(-0.0).text(), "0");
    EXPECT_EQ(Cell(std::optional(0.5)).times(1e2).text(), "50");
    EXPECT_EQ(Cell(7).times(0.5).text(), "7");  // a count has no unit
}

TEST(Column, TerminalTablesShowUnitsBelowNamesAndFourDigits) {
    std::ostringstream out;
    write_table(out, columns, columns, tests, TableFormat::aligned);
    EXPECT_EQ(out.str(),
              "test  tensile_strength      seed\n"
              "                   MPa\n"
              "a                12.35         1\n"
              "b                    -  20000000\n"
              "a                    1         3\n");
}

TEST(Column, GroupsKeepTheOrderInWhichTitlesCome) {
    const auto groups = grouped<Trial>(tests, [](const Trial& t) { return t.name; });
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].first, "a");
    EXPECT_EQ(groups[0].second, (std::vector<const Trial*>{&tests[0], &tests[2]}));
    EXPECT_EQ(groups[1].second, (std::vector<const Trial*>{&tests[1]}));
}

TEST(Column, IntervalsNeedBothEnds) {
    EXPECT_EQ(interval_cell(1e6, 2.5e6, unit::megapascal).text(), "1 to 2.5");
    EXPECT_TRUE(interval_cell(1e6, std::nullopt, unit::megapascal).empty());
}

}  // namespace
}  // namespace graincrack
