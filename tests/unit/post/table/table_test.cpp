#include "post/table/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "post/table/column.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

std::string written(TableFormat format, const std::vector<Cell>& cells, const std::locale& locale = {}) {
    std::ostringstream out;
    out.imbue(locale);
    TableWriter(out, {"name", "value", "count", "nothing"}, format).row(cells);
    return out.str();
}

const std::vector<Cell> row{std::string("|a|\tb \"q\""), 124.3456789012, std::int64_t{1122}, Cell()};

TEST(Table, HoldsTheSameInEveryFormat) {
    for (const auto& [format, name] : {std::pair{TableFormat::tsv, "tsv"}, {TableFormat::markdown, "markdown"}}) {
        test::expect_golden(written(format, row), name);
    }
    const auto line = nlohmann::json::parse(written(TableFormat::jsonl, row));
    EXPECT_EQ(line["name"], "|a|\tb \"q\"");
    EXPECT_DOUBLE_EQ(line["value"].get<double>(), 124.3457);
    EXPECT_EQ(line["count"], 1122);
    EXPECT_TRUE(line["nothing"].is_null());
}

TEST(Table, LeavesEmptyWhatIsNotFinite) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::vector<Cell> cells{std::string("x"), std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
    EXPECT_EQ(test::parse_tsv(written(TableFormat::tsv, cells)).at(1), (std::vector<std::string>{"x", "", "", ""}));
    EXPECT_TRUE(nlohmann::json::parse(written(TableFormat::jsonl, cells))["count"].is_null());
}

TEST(Table, IgnoresTheLocaleOfTheStream) {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale comma(std::locale::classic(), new Comma);
    std::ostringstream out;
    out.imbue(comma);
    out << 1234.5;
    ASSERT_EQ(out.str(), "1.234,5");  // the stream really has another locale
    EXPECT_EQ(written(TableFormat::tsv, row, comma), written(TableFormat::tsv, row));
}

TEST(Table, IsAlignedAsWideAsTheWidestTextOfAColumn) {
    std::ostringstream out;
    {
        TableWriter table(out, {"test", "strength_MPa"}, TableFormat::aligned);
        table.row({std::string("uniaxial"), 121.4321987});
        table.row({std::string("tension"), Cell()});
        EXPECT_EQ(out.str(), "");
    }
    test::expect_golden(out.str());
}

TEST(Table, TurnsRowsWiderThanATerminalIntoColumns) {
    std::ostringstream out;
    std::vector<std::string> names;
    for (int i = 0; i < 30; ++i) names.push_back("column_" + std::to_string(i));
    TableWriter(out, names, TableFormat::aligned).row(std::vector<Cell>(30, Cell(7)));
    test::expect_golden(out.str());
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

TEST(Column, ScalesRealsAndEndsNamesByItsUnit) {
    const auto write = [](std::ostream& out) { write_table(out, columns, tests, TableFormat::tsv); };
    test::expect_golden(test::written(write));
}

TEST(Cell, IsEmptyWithoutAValue) {
    for (const Cell& none : {Cell(std::optional<double>()), Cell(std::nan("")), Cell("")}) EXPECT_TRUE(none.empty());
    EXPECT_TRUE(interval_cell(1e6, std::nullopt, unit::megapascal).empty());
    EXPECT_EQ(interval_cell(1e6, 2.5e6, unit::megapascal).text(), "1 to 2.5");
    EXPECT_FALSE(Cell(0.0).empty());
    EXPECT_EQ(Cell(-0.0).text(), "0");
    EXPECT_EQ(Cell(std::optional(0.5)).times(1e2).text(), "50");
    EXPECT_EQ(Cell(7).times(0.5).text(), "7");  // a count has no unit
    EXPECT_EQ(count_cell(3).text(), "3");
    EXPECT_EQ(count_cell(3.5).text(), "3.5");
}

TEST(Column, HasItsUnitBelowItsNameForPeopleUnlessItIsEmpty) {
    std::ostringstream out;
    write_table(out, columns, columns, tests, TableFormat::aligned);
    out << "\n";
    const Columns<Trial> more{columns[0], {"nothing", unit::megapascal, [](const Trial&) { return Cell(); }}, columns[2]};
    write_table(out, columns, more, {tests[1]}, TableFormat::aligned);
    test::expect_golden(out.str());
}

}  // namespace
}  // namespace graincrack
