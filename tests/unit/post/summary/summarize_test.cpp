// Queries of tables: each against numbers by hand.
#include "post/summary/summarize.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <tuple>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::summary {
namespace {

using test::expect_one_line;
using test::TemporaryFolder;

class Summarize : public ::testing::Test {
protected:
    void SetUp() override {
        std::ofstream(first_) << "run\tlevel\ttest\tstress\tpeak_kind\n"
                                 "a\t10\tdisc\t1\tdrop\n"
                                 "b\t9\tdisc\t10\tdrop\n"
                                 "c\t10\tdisc\t2\tnone\n"
                                 "d\t10\tdisc\t3\t\n"
                                 "e\t10\tdisc\t4\tdrop\n"
                                 "f\t10\tplate\t\tdrop\n";
        std::ofstream(second_) << "level\tslope\n9\t0.5\n10\t0.25\n";
    }
    [[nodiscard]] std::string summary(const SummaryOptions& options, TableFormat format = TableFormat::tsv) const {
        return summary_of({first_, second_, "again=" + second_}, options, format);
    }
    [[nodiscard]] static std::string summary_of(const std::vector<std::string>& files, const SummaryOptions& options,
                                                TableFormat format = TableFormat::tsv) {
        std::ostringstream out;
        write_summary(out, files, options, format);
        return out.str();
    }
    /// One entry, of the four discs at level 10.
    [[nodiscard]] std::string entry(const std::string& expression) const {
        std::string table = summary({.sql = "SELECT " + expression + " AS x FROM first WHERE level = 10 AND test = 'disc'"});
        table.pop_back();
        return table.substr(table.find('\n') + 1);
    }
    [[nodiscard]] double number(const std::string& expression) const { return std::stod(entry(expression)); }
    TemporaryFolder folder_;
    std::string first_ = folder_.file("first.tsv");
    std::string second_ = folder_.file("second-table.tsv");
};

TEST_F(Summarize, SamplesByHand) {
    // Mean 2.5, Σ (x − 2.5)² = 5, t(0.975, 3) = 3.182446
    const double deviation = std::sqrt(5.0 / 3);
    const double half = 3.182446 * deviation / 2;
    EXPECT_EQ(number("mean(stress)"), 2.5);
    EXPECT_NEAR(number("deviation(stress)"), deviation, 1e-6);
    EXPECT_NEAR(number("half_interval(stress)"), half, 1e-6);
    EXPECT_NEAR(number("low(stress)"), 2.5 - half, 1e-6);
    EXPECT_NEAR(number("high(stress)"), 2.5 + half, 1e-6);
    EXPECT_EQ(number("mean(stress * (stress + 1))"), 10);
    EXPECT_EQ(number("mean(stress) FILTER (WHERE stress > 1 AND stress <= 3)"), 2.5);
    EXPECT_EQ(number("2 * sqrt(max(stress))"), 4);
}

TEST_F(Summarize, NothingHasNoStatistic) {
    EXPECT_EQ(entry("mean(stress) FILTER (WHERE stress > 20)"), "");
    EXPECT_EQ(entry("deviation(stress) FILTER (WHERE run = 'a')"), "");
    EXPECT_EQ(entry("mean(NULL)"), "");
    EXPECT_EQ(entry("slope(stress, stress) FILTER (WHERE stress > 20)"), "");
    EXPECT_EQ(entry("mean(1 / (stress - 2)) FILTER (WHERE run = 'c')"), "");
}

TEST_F(Summarize, EntriesAreRealNumbersTextsOrNothing) {
    EXPECT_EQ(entry("max(stress) / 3"), "1.333333");  // no division of whole numbers
    EXPECT_EQ(number("count(run)"), 4);
    EXPECT_EQ(number("count(peak_kind)"), 3);
    EXPECT_EQ(number("count(*) FILTER (WHERE peak_kind <> 'drop')"), 1);  // not that of run d
    EXPECT_EQ(entry("group_concat(DISTINCT typeof(level) || typeof(run))"), "realtext");
}

TEST_F(Summarize, LinesThroughPairs) {
    std::ofstream(first_) << "level\ttest\tconfinement\tstress\tpower\n"
                             "10\tdisc\t0\t100\t\n10\tdisc\t4\t120\t1\n10\tdisc\t8\t140\t8\n";
    // σ1 = 100 + 5 σ3: C = 100/(2 √5), sin φ = 4/6
    EXPECT_NEAR(number("intercept(confinement, stress)"), 100, 1e-6);
    EXPECT_NEAR(number("slope(confinement, stress)"), 5, 1e-6);
    EXPECT_NEAR(number("cohesion(confinement, stress)"), 100 / (2 * std::sqrt(5.0)), 1e-5);
    EXPECT_NEAR(number("friction_angle(confinement, stress)"), std::asin(4.0 / 6) * 180 / M_PI, 1e-5);
    EXPECT_NEAR(number("exponent(confinement, power) FILTER (WHERE confinement > 0)"), 3, 1e-6);
    EXPECT_EQ(number("slope(confinement, power)"), 1.75);  // without the row that has no power
    EXPECT_EQ(number("exponent(nullif(confinement, 0), power)"), 3);
    EXPECT_EQ(entry("exponent(confinement, stress)"), "");
    EXPECT_EQ(entry("slope(level, stress)"), "");
    // Five pairs about y = 2 + 3 x with residuals (1, -1, 0, -1, 1): Σ r² = 4, Σ (x − x̄)² = 10, t(0.975, 3) = 3.182446
    std::ofstream(first_) << "level\ttest\tx\ty\n10\tdisc\t0\t3\n10\tdisc\t1\t4\n10\tdisc\t2\t8\n10\tdisc\t3\t10\n"
                             "10\tdisc\t4\t15\n";
    const double half = 3.182446 * std::sqrt(4.0 / 3 / 10);
    EXPECT_NEAR(number("slope_low(x, y)"), 3 - half, 1e-5);
    EXPECT_NEAR(number("slope_high(x, y)"), 3 + half, 1e-5);
    EXPECT_NEAR(number("intercept_high(x, y) - intercept_low(x, y)"), 2 * half * std::sqrt(6), 1e-5);  // Σ x²/n = 6
    EXPECT_EQ(number("rank_correlation(x, y)"), 1);
    EXPECT_EQ(number("median(y)"), 8);
    EXPECT_EQ(entry("lack_of_fit(x, y)"), "");  // no x occurs twice
}

TEST_F(Summarize, TextsForTables) {
    EXPECT_EQ(entry("text('{:.1f} of {}, {:+.0f}', mean(stress), count(*), max(stress))"), "2.5 of 4, +4");
    EXPECT_EQ(entry("text('{}, {}', 1e6 / 7, max(run))"), "142857.1, e");
    EXPECT_EQ(entry("text('{:+.1f}', -0.0 * count(*))"), "+0.0");
    EXPECT_EQ(entry("text('{:.1f} ± {:.1f}', mean(stress), NULL)"), "");
    EXPECT_EQ(entry("mean_and_half(stress, '+.2f')"), "+2.50 ± 2.05");
    EXPECT_EQ(entry("mean_and_half(stress, '.1f') FILTER (WHERE run = 'c')"), "2.0");
    EXPECT_EQ(entry("mean_and_half(stress, '.1f') FILTER (WHERE run = 'z')"), "-");
    // Each once, in the order of the rows.
    EXPECT_EQ(entry("entries(peak_kind)"), "drop; none");
    EXPECT_EQ(entry("entries(stress)"), "1; 2; 3; 4");
    EXPECT_EQ(entry("ifnull(entries(run) FILTER (WHERE stress > 20), 'none')"), "none");
}

TEST_F(Summarize, TablesHaveNames) {
    EXPECT_EQ(summary({}),
              "run\tlevel\ttest\tstress\tpeak_kind\na\t10\tdisc\t1\tdrop\nb\t9\tdisc\t10\tdrop\nc\t10\tdisc\t2\tnone\n"
              "d\t10\tdisc\t3\t\ne\t10\tdisc\t4\tdrop\nf\t10\tplate\t\tdrop\n");
    // A row without a partner stays.
    EXPECT_EQ(
        summary({.sql = "SELECT run, second_table.slope AS a, again.slope AS b FROM first LEFT JOIN second_table USING (level) "
                        "LEFT JOIN again ON again.level = first.level AND again.slope > 0.3 WHERE run < 'c' ORDER BY run"}),
        "run\ta\tb\na\t0.25\t\nb\t0.5\t0.5\n");
}

TEST_F(Summarize, FilesOfOneNameMakeOneTable) {
    const std::vector<std::string> files{"rows=" + second_, "rows=" + first_};
    EXPECT_EQ(summary_of(files, {.sql = "SELECT level, slope, stress FROM rows WHERE level = 9"}),
              "level\tslope\tstress\n9\t0.5\t\n9\t\t10\n");
    EXPECT_EQ(summary_of(files, {.sql = "SELECT source, count(*) AS n FROM rows GROUP BY source ORDER BY n", .label = "source"}),
              "source\tn\nsecond-table\t2\nfirst\t6\n");
    expect_one_line<InputError>([&] { std::ignore = summary_of(files, {.label = "run"}); },
                                {"first.tsv: has a column run", "--label"});
}

TEST_F(Summarize, AQueryHasSettings) {
    SummaryOptions options{.sql = "SELECT run FROM first WHERE level < :LEVEL OR peak_kind = :KIND",
                           .settings = {"LEVEL=9.5", "KIND=none"}};
    EXPECT_EQ(summary(options), "run\nb\nc\n");
    options.settings = {"LEVEL=", "KIND=none"};  // empty is NULL
    EXPECT_EQ(summary(options), "run\nc\n");
    options.settings = {"LEVEL=3"};
    expect_one_line<UsageError>([&] { std::ignore = summary(options); }, {"--sql", ":KIND has no value", "--set KIND="});
    options.settings = {"LEVEL=3", "KIND=none", "SEED=1"};
    expect_one_line<UsageError>([&] { std::ignore = summary(options); }, {"has no :SEED", "--set"});
    options.settings = {"LEVEL"};
    expect_one_line<UsageError>([&] { std::ignore = summary(options); }, {"--set LEVEL", "NAME=VALUE"});
}

TEST_F(Summarize, NamesBecomeColumns) {
    SummaryOptions options{.sql = "SELECT level, test, 'run ' || run, stress FROM first WHERE run IN ('b', 'c', 'f', 'd')",
                           .pivot = true};
    EXPECT_EQ(summary(options),
              "level\ttest\trun b\trun c\trun d\trun f\n9\tdisc\t10\t\t\t\n10\tdisc\t\t2\t3\t\n10\tplate\t\t\t\t\n");
    options.sql = "SELECT run, stress FROM first WHERE level = 9";
    EXPECT_EQ(summary(options), "b\n10\n");
    options.sql = "SELECT test, level, stress FROM first";
    expect_one_line<UsageError>([&] { std::ignore = summary(options); }, {"--pivot", "two rows of 10 for the same test"});
    options.sql = "SELECT run FROM first";
    expect_one_line<UsageError>([&] { std::ignore = summary(options); }, {"--pivot", "one column"});
}

TEST_F(Summarize, AFileHasTheQuery) {
    const std::string file = folder_.file("levels.sql");
    std::ofstream(file) << "-- Tests of a level.\nSELECT level, count(*) AS \"|n|\"\nFROM first GROUP BY level;\n";
    EXPECT_EQ(summary({.sql = file}, TableFormat::markdown), "| level | \\|n\\| |\n|---|---|\n| 9 | 1 |\n| 10 | 5 |\n");
    std::ofstream(file) << "SELECT run FORM first";
    expect_one_line<UsageError>([&] { std::ignore = summary({.sql = file}); }, {"levels.sql: near \"first\": syntax error"});
    expect_one_line<InputError>([&] { std::ignore = summary({.sql = folder_.file("no.sql")}); }, {"no.sql: cannot be read"});
}

TEST_F(Summarize, RefusesWhatIsNoQueryOfTheTables) {
    const auto with = [this](const std::string& sql) { return [this, sql] { std::ignore = summary({.sql = sql}); }; };
    expect_one_line<UsageError>(with("SELECT strain FROM first"),
                                {"--sql: no such column: strain", "first has run, level", "second_table has level, slope"});
    expect_one_line<UsageError>(with("SELECT \"strain\" FROM first"), {"no such column: strain"});
    expect_one_line<UsageError>(with("SELECT run FROM third"), {"no such table: third", "first has run"});
    expect_one_line<UsageError>(with("SELECT average(stress) FROM first"), {"no such function: average"});
    expect_one_line<UsageError>(with("SELECT 1; SELECT 2"), {"more than one query"});
    expect_one_line<UsageError>(with("SELECT 1; nonsense"), {"more than one query"});
    expect_one_line<UsageError>(with("-- nothing"), {"no query; SELECT"});
    for (const char* const sql :
         {"ATTACH 'other.db' AS other", "PRAGMA user_version", "DELETE FROM first", "DROP TABLE first", "BEGIN",
          "INSERT INTO first (run) VALUES ('g')", "CREATE TABLE other (a)", "VACUUM INTO 'other.db'"}) {
        expect_one_line<UsageError>(with(sql), {"--sql: not allowed; a query is SELECT"});
    }
    expect_one_line<UsageError>(with("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT * FROM n"),
                                {"without recursion"});
    expect_one_line<UsageError>(with("SELECT load_extension('other')"), {"--sql: "});
    expect_one_line<UsageError>(with("SELECT text('{:.1x}', 1)"), {"\".1x\" is no format", ".1f"});
    expect_one_line<UsageError>(with("SELECT text('{:99999999.1f}', 1)"), {"is no format"});
    expect_one_line<UsageError>(with("SELECT text('{:.1f', 1)"), {"text: {:.1f: } is needed"});
    expect_one_line<UsageError>(with("SELECT text('{} {}', 1)"), {"another argument is needed"});
    expect_one_line<UsageError>(with("SELECT text('{}', 1, 2)"), {"text: {}: {} is needed for each argument"});
    expect_one_line<InputError>(with("SELECT mean(run) FROM first"), {"--sql: \"a\"; a number is needed"});
    expect_one_line<InputError>(with("SELECT text('{:.1f}', run) FROM first"), {"\"a\"; a number is needed"});
}

TEST_F(Summarize, RefusesTablesThatCannotBeNamed) {
    std::ofstream(first_) << "run\trun\na\tb\n";
    expect_one_line<InputError>([&] { std::ignore = summary({}); }, {"first.tsv: has two columns of one name: run, run"});
    std::ofstream(first_) << "run\tRUN\na\tb\n";  // one name in SQL
    expect_one_line<InputError>([&] { std::ignore = summary({}); }, {"first.tsv: ", "RUN"});
    expect_one_line<InputError>([&] { std::ignore = summary_of({"rows=none.tsv"}, {}); }, {"none.tsv: cannot be read"});
}

}  // namespace
}  // namespace graincrack::summary
