#include "post/table/documented_tables.hpp"

#include <gtest/gtest.h>

namespace graincrack {
namespace {

using Parts = std::vector<std::string>;

/// Command, file and columns of a table.
Parts parts_of(const TableRow& table) {
    Parts parts{table.command, table.file};
    for (const NamedValue& column : table.columns) parts.push_back(column.name + "[" + column.unit + "] " + column.meaning);
    return parts;
}

TEST(DocumentedTables, AreTheRowsOfOneCommandAndFileEach) {
    const auto tables = tables_of_rows(
        "command\tfile\tcolumns\tmeaning\nstrength\t\tx{,_low}_MPa, steps\ta rule\n"
        "strength\t\truns_at_{1,2}_percent, x1, …\tb\nstrength --table sums\t\tmoment_N_m\tc\nstrength\ta.tsv\tx\td\n");
    ASSERT_EQ(tables.size(), 3U);
    EXPECT_EQ(parts_of(tables[0]), (Parts{"strength", "", "x_MPa[MPa] a rule", "x_low_MPa[MPa] a rule", "steps[] a rule",
                                          "runs_at_1_percent[] b", "runs_at_2_percent[] b", "x1[] b"}));
    EXPECT_EQ(parts_of(tables[1]), (Parts{"strength --table sums", "", "moment_N_m[N_m] c"}));
    EXPECT_EQ(parts_of(tables[2]), (Parts{"strength", "a.tsv", "x[] d"}));
}

}  // namespace
}  // namespace graincrack
