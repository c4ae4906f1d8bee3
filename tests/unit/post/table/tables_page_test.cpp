#include "post/table/tables_page.hpp"

#include <gtest/gtest.h>

namespace graincrack {
namespace {

std::string text_of(const TableRow& table) {
    std::string text = table.command + ":" + table.file + ":";
    for (const NamedValue& column : table.columns) text += " " + column.name + "[" + column.unit + "] " + column.meaning + ";";
    return text;
}

TEST(TablesPage, HasATableForEachHeadBehindTheHeadingOfItsCommand) {
    const auto tables = tables_of_page(
        "# Tables\n\n| column | meaning |\n\n## strength\n\n### Peaks\n\n| column | meaning |\n|---|---|\n"
        "| x{,_low}_MPa, steps | a [rule](#peaks) of \\|x\\| |\n| runs_at_{1,2}_percent, x1, … | b |\n\n| no | column |\n"
        "\n| column of --table sums | meaning |\n|---|---|\n| moment_N_m | c |\n\n| column of a.tsv | meaning |\n|---|---|\n");
    ASSERT_EQ(tables.size(), 4U);
    EXPECT_EQ(text_of(tables[1]),
              "strength:: x_MPa[MPa] a rule of |x|; x_low_MPa[MPa] a rule of |x|; steps[] a rule of |x|; runs_at_1_percent[] b; "
              "runs_at_2_percent[] b; x1[] b;");
    EXPECT_EQ(text_of(tables[2]), "strength --table sums:: moment_N_m[N_m] c;");
    EXPECT_EQ(text_of(tables[3]), "strength:a.tsv:");
}

}  // namespace
}  // namespace graincrack
