// Pages of studies: what each component becomes.
#include "post/report/page.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

TEST(Page, HasTextsTablesAndPicturesInTheirOrder) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.file("about.md")) << "# The *law*\n\nA text.\n";
    std::ofstream(folder.file("size_of-run.tsv")) << "mean_edge\t|σ|\tname\n4.123456\t1.5\ta_b|c\n12345678\t1.234567e-05\t\n";
    const std::string page =
        markdown_page({folder.file("about.md"), folder.file("law-scan.png"), folder.file("size_of-run.tsv")});
    EXPECT_EQ(
        page,
        "# The *law*\n\nA text.\n\n![Law scan](law-scan.png)\n\n## Size of run\n\n| mean edge | \\|σ\\| | name |\n|---|---|---|\n"
        "| 4.123 | 1.5 | a_b\\|c |\n| 12345678 | 1.235e-05 |  |\n\n");
    test::expect_one_line<UsageError>([&] { markdown_page({folder.file("law.pdf")}); }, {"law.pdf", ".md", ".svg"});
    std::ofstream(folder.file("twice.tsv")) << "a\tb\ta\n1\t2\t3\n";
    test::expect_one_line<InputError>([&] { markdown_page({folder.file("twice.tsv")}); }, {"twice.tsv: column a is there twice"});
    test::expect_one_line<InputError>([&] { markdown_page({folder.file("none.md")}); }, {"none.md: cannot be read"});
    test::expect_one_line<InputError>([&] { markdown_page({folder.file("none.tsv")}); }, {"none.tsv: cannot be read"});
}

TEST(Page, IsHtmlToo) {
    const std::string page =
        html_page("# Law & order\n\nA *text* with `code` <b>.\n\n![Law](law.png)\n\n| a | b |\n|---|---|\n| 1\\|2 | x |\n");
    EXPECT_NE(page.find("<title>Law &amp; order</title>"), std::string::npos) << page;
    EXPECT_NE(page.find("<h1>Law &amp; order</h1>"), std::string::npos) << page;
    EXPECT_NE(page.find("<em>text</em> with <code>code</code> &lt;b&gt;"), std::string::npos) << page;
    EXPECT_NE(page.find("<img src=\"law.png\" alt=\"Law\">"), std::string::npos) << page;
    EXPECT_NE(page.find("<td>1|2</td>"), std::string::npos) << page;
}

}  // namespace
}  // namespace graincrack
