#include "post/table/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "post/table/column.hpp"
#include "share/base/error.hpp"

namespace graincrack {
namespace {

std::string written(TableFormat format, const std::vector<Cell>& cells) {
    std::ostringstream out;
    TableWriter(out, {"name", "value", "count", "nothing"}, format).row(cells);
    return out.str();
}

const std::vector<Cell> row{std::string("a\tb \"q\""), 124.3456789012, std::int64_t{1122}, Cell()};

TEST(Table, TsvHasOneHeaderLineAndSevenDigits) {
    EXPECT_EQ(written(TableFormat::tsv, row), "name\tvalue\tcount\tnothing\na b \"q\"\t124.3457\t1122\t\n");
}

TEST(Table, JsonLinesHoldTheSame) {
    const auto line = nlohmann::json::parse(written(TableFormat::jsonl, row));
    EXPECT_EQ(line["name"], "a\tb \"q\"");
    EXPECT_DOUBLE_EQ(line["value"].get<double>(), 124.3457);
    EXPECT_EQ(line["count"], 1122);
    EXPECT_TRUE(line["nothing"].is_null());
}

TEST(Table, MarkdownHasARuleAndNoOpenBars) {
    EXPECT_EQ(written(TableFormat::markdown, {std::string("|a|\tb"), 1.5, std::int64_t{2}, Cell()}),
              "| name | value | count | nothing |\n|---|---|---|---|\n| \\|a\\| b | 1.5 | 2 |  |\n");
}

TEST(Table, WhatIsNotFiniteIsEmpty) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::vector<Cell> cells{std::string("x"), std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
    EXPECT_EQ(written(TableFormat::tsv, cells), "name\tvalue\tcount\tnothing\nx\t\t\t\n");
    EXPECT_TRUE(nlohmann::json::parse(written(TableFormat::jsonl, cells))["count"].is_null());
}

TEST(Table, NumbersIgnoreTheLocaleOfTheStream) {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    std::ostringstream out;
    out.imbue(std::locale(std::locale::classic(), new Comma));
    out << 1234.5;
    ASSERT_EQ(out.str(), "1.234,5");  // the stream really has another locale
    out.str("");
    TableWriter(out, {"a", "b"}, TableFormat::tsv).row({1234.5, std::int64_t{1000000}});
    EXPECT_EQ(out.str(), "a\tb\n1234.5\t1000000\n");
}

TEST(Table, CountsAreWholeUnlessTheyAreHalves) {
    EXPECT_EQ(count_cell(3).text(), "3");
    EXPECT_EQ(count_cell(3.5).text(), "3.5");
    EXPECT_TRUE(Cell(std::optional<double>()).empty());
}

TEST(Table, AlignedColumnsAreAsWideAsTheirWidestText) {
    std::ostringstream out;
    {
        TableWriter table(out, {"test", "strength_MPa"}, TableFormat::aligned);
        table.row({std::string("uniaxial"), 121.4321987});
        table.row({std::string("tension"), Cell()});
        EXPECT_EQ(out.str(), "");
    }
    EXPECT_EQ(out.str(), "test      strength_MPa\nuniaxial        121.43\ntension              -\n");
}

TEST(Table, AlignedRowsWiderThanATerminalBecomeColumns) {
    std::ostringstream out;
    std::vector<std::string> names;
    std::vector<Cell> cells;
    for (std::int64_t i = 0; i < 30; ++i) {
        names.push_back("column_" + std::to_string(i));
        cells.emplace_back(i);
    }
    TableWriter(out, names, TableFormat::aligned).row(cells);
    EXPECT_TRUE(out.str().starts_with("column_0    0\ncolumn_1    1\n")) << out.str();
    EXPECT_EQ(std::ranges::count(out.str(), '\n'), 30);
}

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

TEST(Column, TerminalTablesLeaveOutWhatIsEmptyInAllRows) {
    std::ostringstream out;
    const Columns<Trial> more{columns[0], {"nothing", unit::megapascal, [](const Trial&) { return Cell(); }}, columns[2]};
    write_table(out, columns, more, {tests[1]}, TableFormat::aligned);
    EXPECT_EQ(out.str(), "test      seed\nb     20000000\n");
}

TEST(Column, IntervalsNeedBothEnds) {
    EXPECT_EQ(interval_cell(1e6, 2.5e6, unit::megapascal).text(), "1 to 2.5");
    EXPECT_TRUE(interval_cell(1e6, std::nullopt, unit::megapascal).empty());
}

}  // namespace
}  // namespace graincrack
