// Statistics of tables by groups: each against numbers by hand.
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
    [[nodiscard]] std::string summary(const SummaryOptions& options, bool both = false) const {
        std::ostringstream out;
        write_summary(out, both ? std::vector<std::string>{first_, second_} : std::vector<std::string>{first_}, options);
        return out.str();
    }
    /// One number of the four discs at level 10.
    [[nodiscard]] double number(const std::string& expression) const {
        const std::string table = summary({{}, "", {"level=10", "test=disc"}, {"x=" + expression}, false, TableFormat::tsv});
        return std::stod(table.substr(table.find('\n') + 1));
    }
    TemporaryFolder folder_;
    std::string first_ = folder_.file("first.tsv");
    std::string second_ = folder_.file("second.tsv");
};

TEST_F(Summarize, SamplesByHand) {
    // Mean 2.5, Σ (x − 2.5)² = 5, t(0.975, 3) = 3.182446
    const double deviation = std::sqrt(5.0 / 3);
    const double half = 3.182446 * deviation / 2;
    EXPECT_EQ(number("n(stress)"), 4);
    EXPECT_EQ(number("first(stress)"), 1);
    EXPECT_EQ(number("sum(stress)"), 10);
    EXPECT_EQ(number("mean(stress)"), 2.5);
    EXPECT_EQ(number("smallest(stress)"), 1);
    EXPECT_EQ(number("largest(stress)"), 4);
    EXPECT_NEAR(number("deviation(stress)"), deviation, 1e-6);
    EXPECT_NEAR(number("half_interval(stress)"), half, 1e-6);
    EXPECT_NEAR(number("low(stress)"), 2.5 - half, 1e-6);
    EXPECT_NEAR(number("high(stress)"), 2.5 + half, 1e-6);
}

TEST_F(Summarize, ExpressionsOfRowsAndOfGroups) {
    EXPECT_EQ(number("mean(stress * stress + 1)"), 8.5);
    EXPECT_EQ(number("mean(stress * (stress + 1))"), 10);
    EXPECT_EQ(number("-mean(8 - stress - 1)"), -4.5);
    EXPECT_EQ(number("100 * (mean(stress where run=e) / mean(stress where run=a) - 1)"), 300);
    EXPECT_EQ(number("mean(stress where stress>1 and stress<=3)"), 2.5);
    EXPECT_EQ(number("1e1 * n(run)"), 40);  // texts are counted
}

TEST_F(Summarize, AnEmptyEntryDiffersFromNothing) {
    EXPECT_EQ(number("n(run where peak_kind!=drop)"), 1);  // not that of run d
}

TEST_F(Summarize, LinesThroughPairs) {
    std::ofstream(first_) << "level\ttest\tconfinement\tstress\tpower\n"
                             "10\tdisc\t0\t100\t\n10\tdisc\t4\t120\t1\n10\tdisc\t8\t140\t8\n";
    // σ1 = 100 + 5 σ3: C = 100/(2 √5), sin φ = 4/6
    EXPECT_NEAR(number("intercept(confinement, stress)"), 100, 1e-6);
    EXPECT_NEAR(number("slope(confinement, stress)"), 5, 1e-6);
    EXPECT_NEAR(number("cohesion(confinement, stress)"), 100 / (2 * std::sqrt(5.0)), 1e-5);
    EXPECT_NEAR(number("friction_angle(confinement, stress)"), std::asin(4.0 / 6) * 180 / M_PI, 1e-5);
    EXPECT_NEAR(number("exponent(confinement, power where confinement>0)"), 3, 1e-6);
    // A fit without one of its values would be another fit.
    EXPECT_EQ(summary({{}, "", {}, {"x=slope(confinement, power)", "y=n(power)"}, false, TableFormat::tsv}), "x\ty\n\t2\n");
}

TEST_F(Summarize, GroupsAsTheyComeOrSorted) {
    const SummaryOptions options{{"level", "test"}, "", {}, {"n=n(run)", "mean=mean(stress)"}, false, TableFormat::tsv};
    EXPECT_EQ(summary(options), "level\ttest\tn\tmean\n10\tdisc\t4\t2.5\n9\tdisc\t1\t10\n10\tplate\t1\t\n");
    SummaryOptions sorted = options;
    sorted.sort = true;  // 9 is before 10
    EXPECT_EQ(summary(sorted), "level\ttest\tn\tmean\n9\tdisc\t1\t10\n10\tdisc\t4\t2.5\n10\tplate\t1\t\n");
}

TEST_F(Summarize, RowsOfSeveralTablesJoinInAGroup) {
    EXPECT_EQ(summary({{"level"}, "", {"test!=plate"}, {"n=n(run)"}, false, TableFormat::tsv}, true), "level\tn\n10\t4\n9\t1\n");
    EXPECT_EQ(summary({{"level"},
                       "",
                       {},
                       {"stress=mean(stress)", "slope=first(slope)", "any=mean(stress | slope)"},
                       false,
                       TableFormat::tsv},
                      true),
              "level\tstress\tslope\tany\n10\t2.5\t0.25\t2.05\n9\t10\t0.5\t5.25\n");
}

TEST_F(Summarize, RowsWithOneEntryBecomeOne) {
    std::ofstream(second_) << "run\tslope\tlevel\nb\t0.5\t7\na\t0.25\t8\n";
    SummaryOptions options{{"level"}, "run", {}, {"runs=n(run)", "slope=sum(slope)"}, false, TableFormat::tsv};
    EXPECT_EQ(summary(options, true), "level\truns\tslope\n10\t5\t0.25\n9\t1\t0.5\n");
    options.join = "";
    EXPECT_EQ(summary(options, true), "level\truns\tslope\n10\t5\t\n9\t1\t\n7\t1\t0.5\n8\t1\t0.25\n");
}

TEST_F(Summarize, GroupsByAnExpression) {
    const SummaryOptions options{{"next=level + 1 | 0"}, "", {}, {"n=n(run)"}, false, TableFormat::tsv};
    EXPECT_EQ(summary(options), "next\tn\n11\t5\n10\t1\n");
}

TEST_F(Summarize, MagnitudesOfRowsAndOfGroups) {
    EXPECT_EQ(number("largest(abs(stress - 4))"), 3);
    EXPECT_EQ(number("abs(mean(stress) - 4) + 1"), 2.5);
    EXPECT_EQ(number("mean(abs(2 * stress))"), 5);
}

TEST_F(Summarize, TextsWithNumbersOfAGroup) {
    const auto text = [this](const std::string& shown) {
        const std::string table = summary({{}, "", {}, {"x=" + shown}, false, TableFormat::tsv});
        return table.substr(2);
    };
    EXPECT_EQ(text("{mean(stress where level=10):.1f} of {n(run)}, {largest(stress):+.0f}"), "2.5 of 6, +10\n");
    // Entries that are not empty, each once, in the order of the rows.
    EXPECT_EQ(text("ended by {peak_kind}"), "ended by drop; none\n");
    EXPECT_EQ(text("[{run where stress>2 and level=10};none]"), "d; e\n");
    EXPECT_EQ(text("[{run where stress>20};none]"), "none\n");
    // The first alternative without anything empty; "-" without any, and for what is empty outside.
    EXPECT_EQ(
        text("[{mean(stress where level=9):.1f} ± {deviation(stress where level=9):.1f};{mean(stress where level=9):.1f}] MPa"),
        "10.0 MPa\n");
    EXPECT_EQ(text("[{deviation(stress where level=9):.1f}] and {deviation(stress where level=9):.1f}"), "- and -\n");
    EXPECT_EQ(text("{mean(stress - stress):+.1f}"), "+0.0\n");
}

TEST_F(Summarize, SaysWhatATextLacks) {
    const auto with = [this](const std::string& text) {
        return [this, text] { std::ignore = summary({{}, "", {}, {"x=" + text}, false, TableFormat::tsv}); };
    };
    expect_one_line<UsageError>(with("{mean(stress):.1f"), {"{mean(stress):.1f", "} is needed"});
    expect_one_line<UsageError>(with("[{mean(stress):.1f}"), {"] is needed"});
    expect_one_line<UsageError>(with("{mean(stress):.1x}"), {"\".1x\" is no format", ".1f"});
    expect_one_line<UsageError>(with("{average(stress):.1f}"), {"average(stress)", "half_interval"});
    expect_one_line<UsageError>(with("{run where stress~2}"), {"{run where stress~2}", "COLUMN=VALUE"});
    expect_one_line<InputError>(with("{strain}"), {"first.tsv", "no column strain"});
    expect_one_line<InputError>(with("{run where strain>2}"), {"no column strain"});
}

TEST_F(Summarize, ATableOfRunsSaysWhatTheyAre) {
    // Run a is in two series, run c in none.
    std::ofstream(second_) << "run\tseries\tangle\na\tx\t0\nb\tx\t30\na\ty\t90\nzz\ty\t0\n";
    SummaryOptions options{{"series"}, "", {"stress<3.5"}, {"runs={run}", "stress=sum(stress)", "angle=largest(angle)"}};
    options.look_up = {second_};
    EXPECT_EQ(summary(options), "series\truns\tstress\tangle\nx\ta\t1\t0\ny\ta\t1\t90\n\tc; d\t5\t\n");
    std::ofstream(second_) << "run\tlevel\na\t0\n";
    expect_one_line<InputError>([&] { std::ignore = summary(options); }, {"second.tsv: column level is in", "first.tsv too"});
    std::ofstream(second_) << "file\tseries\na\tx\n";
    expect_one_line<InputError>([&] { std::ignore = summary(options); }, {"first.tsv: no column file"});
}

TEST_F(Summarize, TablesHaveLabels) {
    SummaryOptions options{{"from"}, "", {}, {"n=n(level)", "slope=sum(slope)"}};
    options.label = "from";
    const auto labelled = [&](const std::vector<std::string>& files) {
        std::ostringstream out;
        write_summary(out, files, options);
        return out.str();
    };
    EXPECT_EQ(labelled({"a=" + first_, "b=" + second_}), "from\tn\tslope\na\t6\t\nb\t2\t0.75\n");
    options.join = "level";  // rows of the second table fill those of the first, whose label they keep
    EXPECT_EQ(labelled({"a=" + first_, "b=" + second_}), "from\tn\tslope\na\t2\t0.75\n");
    expect_one_line<UsageError>([&] { std::ignore = labelled({"a=" + first_, second_}); }, {second_, "LABEL=FILE"});
    options.label = "level";
    options.join = "";
    expect_one_line<InputError>([&] { std::ignore = labelled({"a=" + first_}); }, {"first.tsv: has a column level", "--label"});
}

TEST_F(Summarize, WritesMarkdown) {
    SummaryOptions options{{"test"}, "", {}, {"n=n(run)", "|σ|, MPa={mean(stress):.1f}"}};
    options.format = TableFormat::markdown;
    EXPECT_EQ(summary(options), "| test | n | \\|σ\\|, MPa |\n|---|---|---|\n| disc | 5 | 4.0 |\n| plate | 1 | - |\n");
}

TEST_F(Summarize, SaysWhatItCannotUnderstand) {
    const auto with = [this](const std::string& column) {
        return [this, column] { std::ignore = summary({{}, "", {}, {column}, false, TableFormat::tsv}); };
    };
    expect_one_line<UsageError>(with("mean(stress)"), {"--column mean(stress)", "NAME=EXPRESSION"});
    expect_one_line<UsageError>(with("x=average(stress)"), {"at \"average(stress)\"", "half_interval", "mean(COLUMN)"});
    expect_one_line<UsageError>(with("x=mean(stress"), {") is needed"});
    expect_one_line<UsageError>(with("x=slope(stress)"), {", is needed"});
    expect_one_line<UsageError>(with("x=mean(stress) mean(stress)"), {"at \"mean(stress)\"", "operator"});
    expect_one_line<UsageError>(with("x=mean(stress where level~3)"), {"level~3", "COLUMN=VALUE"});
    const std::string deep(20000, '(');
    expect_one_line<UsageError>(with("x=" + deep + "mean(stress)"), {"more than 1000"});
    expect_one_line<UsageError>(with("x=mean(" + deep + "stress))"), {"more than 1000"});
    expect_one_line<UsageError>(with("x=" + std::string(20000, '-') + "mean(stress)"), {"more than 1000"});
    std::string chain = "x=mean(stress";
    for (int i = 0; i < 60000; ++i) chain += "/1";
    expect_one_line<UsageError>(with(chain + ")"), {"more than 1000"});
    try {
        with(chain + ")")();
    } catch (const UsageError& error) {
        EXPECT_LT(std::string(error.what()).size(), 600U);
    }
    expect_one_line<InputError>(with("x=mean(strain)"), {"first.tsv", "no column strain", "stress"});
    expect_one_line<InputError>(with("x=mean(run)"), {"run", "\"a\"", "a number is needed"});
    expect_one_line<InputError>(
        [this] {
            std::ignore = summary({{"seed"}, "", {}, {}, false, TableFormat::tsv});
        },
        {"no column seed"});
    expect_one_line<UsageError>(
        [this] {
            std::ignore = summary({{}, "", {"level<x"}, {}, false, TableFormat::tsv});
        },
        {"--where level<x"});
}

}  // namespace
}  // namespace graincrack::summary
