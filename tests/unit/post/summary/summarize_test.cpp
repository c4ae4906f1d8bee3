// Queries of tables: each against numbers by hand.
#include "post/summary/summarize.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <tuple>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/rows.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack::summary {
namespace {

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
        return test::written(write_summary, files, options, format);
    }
    /// One entry, of the four discs at level 10.
    [[nodiscard]] std::string entry(const std::string& expression) const {
        std::string table = summary({.sql = "SELECT " + expression + " AS x FROM first WHERE level = 10 AND test = 'disc'"});
        table.pop_back();
        return table.substr(table.find('\n') + 1);
    }
    template <class Exception>
    void refuse(const std::string& what, const SummaryOptions& options) {
        refused_.add<Exception>(what, [&] { std::ignore = summary(options); });
    }
    [[nodiscard]] double number(const std::string& expression) const { return std::stod(entry(expression)); }
    void expect(const std::vector<std::pair<std::string, double>>& numbers) const {
        for (const auto& [expression, expected] : numbers) EXPECT_NEAR(number(expression), expected, 1e-5) << expression;
    }
    test::TemporaryFolder folder_;
    test::GoldenRefusals refused_{"refused"};
    std::string first_ = folder_.file("first.tsv");
    std::string second_ = folder_.file("second-table.tsv");
};

TEST_F(Summarize, MeasuresSamplesAsByHand) {
    // Mean 2.5, Σ (x − 2.5)² = 5, t(0.975, 3) = 3.182446
    const double deviation = std::sqrt(5.0 / 3);
    const double half = 3.182446 * deviation / 2;
    expect({{"mean(stress)", 2.5},
            {"deviation(stress)", deviation},
            {"half_interval(stress)", half},
            {"low(stress)", 2.5 - half},
            {"high(stress)", 2.5 + half},
            {"mean(stress * (stress + 1))", 10},
            {"mean(stress) FILTER (WHERE stress > 1 AND stress <= 3)", 2.5},
            {"2 * sqrt(max(stress))", 4}});
}

TEST_F(Summarize, HasNoStatisticOfNothing) {
    for (const char* const nothing :
         {"mean(stress) FILTER (WHERE stress > 20)", "deviation(stress) FILTER (WHERE run = 'a')", "mean(NULL)",
          "slope(stress, stress) FILTER (WHERE stress > 20)", "mean(1 / (stress - 2)) FILTER (WHERE run = 'c')"}) {
        EXPECT_EQ(entry(nothing), "") << nothing;
    }
}

TEST_F(Summarize, TakesEntriesAsRealNumbersTextsOrNothing) {
    EXPECT_EQ(entry("max(stress) / 3"), "1.333333");  // no division of whole numbers
    expect(
        {{"count(run)", 4}, {"count(peak_kind)", 3}, {"count(*) FILTER (WHERE peak_kind <> 'drop')", 1}});  // not that of run d
    EXPECT_EQ(entry("group_concat(DISTINCT typeof(level) || typeof(run))"), "realtext");
}

TEST_F(Summarize, FitsLinesThroughPairs) {
    std::ofstream(first_) << "level\ttest\tconfinement\tstress\tpower\n"
                             "10\tdisc\t0\t100\t\n10\tdisc\t4\t120\t1\n10\tdisc\t8\t140\t8\n";
    // σ1 = 100 + 5 σ3: C = 100/(2 √5), sin φ = 4/6
    expect({{"intercept(confinement, stress)", 100},
            {"slope(confinement, stress)", 5},
            {"cohesion(confinement, stress)", 100 / (2 * std::sqrt(5.0))},
            {"friction_angle(confinement, stress)", std::asin(4.0 / 6) * 180 / M_PI},
            {"exponent(confinement, power) FILTER (WHERE confinement > 0)", 3},
            {"slope(confinement, power)", 1.75},  // without the row that has no power
            {"exponent(nullif(confinement, 0), power)", 3}});
    for (const char* const nothing : {"exponent(confinement, stress)", "slope(level, stress)"}) EXPECT_EQ(entry(nothing), "");
    // Five pairs about y = 2 + 3 x with residuals (1, -1, 0, -1, 1): Σ r² = 4, Σ (x − x̄)² = 10, t(0.975, 3) = 3.182446
    std::ofstream(first_) << "level\ttest\tx\ty\n10\tdisc\t0\t3\n10\tdisc\t1\t4\n10\tdisc\t2\t8\n10\tdisc\t3\t10\n"
                             "10\tdisc\t4\t15\n";
    const double half = 3.182446 * std::sqrt(4.0 / 3 / 10);
    expect({{"slope_low(x, y)", 3 - half},
            {"slope_high(x, y)", 3 + half},
            {"intercept_high(x, y) - intercept_low(x, y)", 2 * half * std::sqrt(6)},  // Σ x²/n = 6
            {"rank_correlation(x, y)", 1},
            {"median(y)", 8}});
    EXPECT_EQ(entry("lack_of_fit(x, y)"), "");  // no x occurs twice
}

TEST_F(Summarize, MakesTextsForTables) {
    std::string texts;
    for (const char* const expression :
         {"text('{:.1f} of {}, {:+.0f}', mean(stress), count(*), max(stress))", "text('{}, {}', 1e6 / 7, max(run))",
          "text('{:+.1f}', -0.0 * count(*))", "text('{:.1f} ± {:.1f}', mean(stress), NULL)", "mean_and_half(stress, '+.2f')",
          "mean_and_half(stress, '.1f') FILTER (WHERE run = 'c')", "mean_and_half(stress, '.1f') FILTER (WHERE run = 'z')",
          "entries(peak_kind)", "entries(stress)",  // each once, in the order of the rows
          "ifnull(entries(run) FILTER (WHERE stress > 20), 'none')"}) {
        texts += std::string(expression) + ": " + entry(expression) + "\n";
    }
    test::expect_golden(texts);
}

TEST_F(Summarize, NamesTablesByTheirFiles) {
    EXPECT_EQ(summary({}), test::read_text(first_));
    // A row without a partner stays.
    test::expect_golden(
        summary({.sql = "SELECT run, second_table.slope AS a, again.slope AS b FROM first LEFT JOIN second_table USING (level) "
                        "LEFT JOIN again ON again.level = first.level AND again.slope > 0.3 WHERE run < 'c' ORDER BY run"}));
}

TEST_F(Summarize, JoinsFilesOfOneName) {
    const std::vector<std::string> files{"rows=" + second_, "rows=" + first_};
    test::expect_golden(summary_of(files, {.sql = "SELECT level, slope, stress FROM rows WHERE level = 9"}));
    test::expect_golden(
        summary_of(files, {.sql = "SELECT source, count(*) AS n FROM rows GROUP BY source ORDER BY n", .label = "source"}),
        "labelled");
    refused_.add<InputError>("a label that is a column", [&] { std::ignore = summary_of(files, {.label = "run"}); });
}

TEST_F(Summarize, GivesSettingsToAQuery) {
    SummaryOptions options{.sql = "SELECT run FROM first WHERE level < :LEVEL OR peak_kind = :KIND",
                           .settings = {"LEVEL=9.5", "KIND=none"}};
    EXPECT_EQ(summary(options), "run\nb\nc\n");
    options.settings = {"LEVEL=", "KIND=none"};  // empty is NULL
    EXPECT_EQ(summary(options), "run\nc\n");
    for (const std::vector<std::string>& wrong :
         {std::vector<std::string>{"LEVEL=3"}, {"LEVEL=3", "KIND=none", "SEED=1"}, {"LEVEL"}}) {
        options.settings = wrong;
        refuse<UsageError>(wrong.back(), options);
    }
}

TEST_F(Summarize, TurnsNamesIntoColumns) {
    const auto options = [](const char* sql) { return SummaryOptions{.sql = sql, .pivot = true}; };
    test::expect_golden(
        summary(options("SELECT level, test, 'run ' || run, stress FROM first WHERE run IN ('b', 'c', 'f', 'd')")) + "\n" +
        summary(options("SELECT run, stress FROM first WHERE level = 9")));
    refuse<UsageError>("a name twice", options("SELECT test, level, stress FROM first"));
    refuse<UsageError>("no value", options("SELECT run FROM first"));
}

TEST_F(Summarize, ReadsTheQueryFromAFile) {
    const std::string file = folder_.file("levels.sql");
    std::ofstream(file) << "-- Tests of a level.\nSELECT level, count(*) AS \"|n|\"\nFROM first GROUP BY level;\n";
    test::expect_golden(summary({.sql = file}, TableFormat::markdown));
    std::ofstream(file) << "SELECT run FORM first";
    refuse<UsageError>("no SQL", {.sql = file});
    refuse<InputError>("no file", {.sql = folder_.file("no.sql")});
}

TEST_F(Summarize, RefusesWhatIsNoQueryOfTheTables) {
    EXPECT_EQ(test::expect_refused<UsageError>("post/summary/query.toml",
                                               [this](const std::string& sql) { std::ignore = summary({.sql = sql}); }),
              22U);
    const auto ask = [&](const std::string& column) { std::ignore = summary({.sql = "SELECT " + column + " FROM first"}); };
    refused_.add_each<InputError>({"mean(run)", "text('{:.1f}', run)"}, ask);
}

TEST_F(Summarize, RefusesTablesThatCannotBeNamed) {
    for (const std::string name : {"run", "RUN"}) {  // one name in SQL
        std::ofstream(first_) << "run\t" << name << "\na\tb\n";
        refuse<InputError>(name, {});
    }
    refused_.add<InputError>("no file", [] { std::ignore = summary_of({"rows=none.tsv"}, {}); });
}

}  // namespace
}  // namespace graincrack::summary
