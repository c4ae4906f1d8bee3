// Verdicts on claims: what decides them, on numbers with known answers, and the claims of every study on tables whose verdicts
// are known.
#include "post/claims/claims_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "post/claims/evaluate.hpp"
#include "post/statistics/rank.hpp"
#include "post/table/table_file.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::claims {
namespace {

namespace fs = std::filesystem;
using test::expect_one_line;
using test::TemporaryFolder;

Estimate within(double value, double half) { return {value, value - half, value + half}; }
Estimate alone(double value) { return {value, std::nullopt, std::nullopt}; }

TEST(Verdicts, ANumberWithinATolerance) {
    EXPECT_EQ(judge_value(within(103, 2), 100, 5), Verdict::holds);
    EXPECT_EQ(judge_value(within(103, 8), 100, 5), Verdict::open);  // the interval is wider than the tolerance
    EXPECT_EQ(judge_value(within(108, 4), 100, 5), Verdict::open);  // the interval reaches into the tolerance
    EXPECT_EQ(judge_value(within(108, 2), 100, 5), Verdict::differs);
    EXPECT_EQ(judge_value(alone(92), 100, 5), Verdict::differs);
    EXPECT_EQ(judge_value(alone(96), 100, 5), Verdict::holds);
}

TEST(Verdicts, ANumberInOurInterval) {
    EXPECT_EQ(judge_covered(within(0.3, 0.1), 0.39, 0.5), Verdict::holds);
    EXPECT_EQ(judge_covered(within(0.2, 0.1), 0.39, 0.5), Verdict::differs);
    EXPECT_EQ(judge_covered(within(0.3, 0.3), 0.39, 0.5), Verdict::open);
    EXPECT_EQ(judge_covered(alone(0.39), 0.39, 0.5), Verdict::open);
}

TEST(Verdicts, Signs) {
    EXPECT_EQ(judge_sign(within(2, 1), true), Verdict::holds);
    EXPECT_EQ(judge_sign(within(2, 1), false), Verdict::differs);
    EXPECT_EQ(judge_sign(within(-2, 1), false), Verdict::holds);
    EXPECT_EQ(judge_sign(within(1, 2), true), Verdict::open);
    EXPECT_EQ(judge_sign(alone(2), true), Verdict::open);
}

TEST(Verdicts, Bounds) {
    EXPECT_EQ(judge_order(within(0.6, 0.05), {0.5, true, false}), Verdict::holds);
    EXPECT_EQ(judge_order(within(0.6, 0.05), {0.5, false, false}), Verdict::differs);
    EXPECT_EQ(judge_order(within(0.6, 0.2), {0.5, true, false}), Verdict::open);
    EXPECT_EQ(judge_order(alone(0.85), {0.85, true, true}), Verdict::holds);
    EXPECT_EQ(judge_order(alone(0.85), {0.85, true, false}), Verdict::differs);
}

TEST(Verdicts, Changes) {
    EXPECT_EQ(judge_change(within(1, 0.3), within(2, 0.4), true), Verdict::holds);  // 1 against √(0.09 + 0.16)
    EXPECT_EQ(judge_change(within(1, 0.3), within(2, 0.4), false), Verdict::differs);
    EXPECT_EQ(judge_change(within(1, 0.9), within(2, 0.9), true), Verdict::open);
    EXPECT_EQ(judge_change(within(1, 0.3), alone(2), true), Verdict::open);
}

TEST(Verdicts, SpreadOverLevels) {
    const std::vector<Estimate> near{within(100, 4), within(104, 3), within(109, 3)};
    EXPECT_EQ(judge_spread(near, 0.1).verdict, Verdict::holds);
    EXPECT_NEAR(judge_spread(near, 0.1).relative, 0.09, 1e-12);
    EXPECT_EQ(judge_spread(near, 0.08).verdict, Verdict::open);  // 0.09 − 0.05 reaches into it
    EXPECT_EQ(judge_spread(near, 0.03).verdict, Verdict::differs);
}

TEST(Rank, CorrelationAndMedian) {
    const std::vector<double> x{1, 2, 3, 4};
    EXPECT_NEAR(rank_correlation(x, std::vector<double>{1, 3, 2, 4}), 1 - 6 * 2 / (4.0 * 15), 1e-12);
    EXPECT_NEAR(median(x), 2.5, 1e-12);
    EXPECT_NEAR(median(std::vector<double>{7, 1, 3}), 3, 1e-12);
}

/// Claims and one table of results, written to files.
class ClaimsOfATable : public ::testing::Test {
protected:
    void write(const std::string& name, const std::string& content) { std::ofstream(folder_.file(name)) << content; }
    std::string verdicts(const std::string& claims, const ClaimsOptions& options = {}) {
        write("claims.tsv", claims);
        std::ostringstream out;
        write_claims(out, folder_.file("claims.tsv"), {folder_.file("results.tsv")}, options);
        return out.str();
    }
    std::string verdict(const std::string& fields, const std::string& header = "") {
        const std::string table = verdicts("claim\tkind\ttable\tcolumn\tpaper" + header + "\na\t" + fields + "\n");
        std::istringstream row(table.substr(table.find('\n') + 1));
        std::string field;
        for (int i = 0; i < 6; ++i) std::getline(row, field, '\t');
        return field;
    }

    TemporaryFolder folder_;
};

TEST_F(ClaimsOfATable, MeansOverRowsHaveStudentsInterval) {
    // Mean 10, deviation 1, t(0.975, 2) = 4.3027: half 2.484
    write("results.tsv", "x\n9\n10\n11\n");
    EXPECT_EQ(verdict("value\tresults\tx\t10\t25%", "\ttolerance"), "holds");
    EXPECT_EQ(verdict("value\tresults\tx\t10\t24%", "\ttolerance"), "open");
    EXPECT_EQ(verdict("value\tresults\tx\t20\t7.5", "\ttolerance"), "differs");
    EXPECT_EQ(verdict("value\tresults\tx\t20\t7.6", "\ttolerance"), "open");
    // Standard error 0.577: 10 is 17.3 of them above 0
    EXPECT_EQ(verdict("order\tresults\tx\t>=0\t17 standard errors", "\ttolerance"), "holds");
    EXPECT_EQ(verdict("order\tresults\tx\t>=0\t18 standard errors", "\ttolerance"), "differs");
}

TEST_F(ClaimsOfATable, EqualWhenRounded) {
    write("results.tsv", "x\n0.0934\n");
    EXPECT_EQ(verdict("equality\tresults\tx\t0.093\t0.0005", "\ttolerance"), "holds");
    EXPECT_EQ(verdict("equality\tresults\tx\t0.094\t0.0005", "\ttolerance"), "differs");
}

TEST_F(ClaimsOfATable, LevelsOnTheSameSpecimens) {
    // Specimen 2 is twice as strong; both change by 3 % from level 1 to level 2, and by 10 % to level 3.
    write("results.tsv", "level\tseed\tx\n1\t1\t100\n1\t2\t200\n2\t1\t103\n2\t2\t206\n3\t1\t110\n3\t2\t220\n");
    const std::string header = "\twhere\ttolerance\tby\tpair";
    EXPECT_EQ(verdict("equality\tresults\tx\tequal\tlevel<=2\t5%\tlevel\tseed", header), "holds");
    EXPECT_EQ(verdict("equality\tresults\tx\tequal\t\t5%\tlevel\tseed", header), "differs");
    EXPECT_EQ(verdict("equality\tresults\tx\tequal\tlevel=2\t5%\tlevel\tseed", header), "open");
}

TEST_F(ClaimsOfATable, SettingsAndNeeds) {
    write("results.tsv", "x\tlow\thigh\tslope_low\n5\t-1\t11\t-1\n");
    ClaimsOptions options;
    options.settings["X"] = "5";
    const std::string header = "claim\tkind\ttable\tcolumn\tpaper\ttolerance\tinterval\tneeds\n";
    EXPECT_NE(verdicts(header + "a\tvalue\tresults\tx\t{X}\tinterval\tlow:high\t\n", options).find("\tholds\t"),
              std::string::npos);
    EXPECT_NE(verdicts(header + "a\tvalue\tresults\tx\t{X}\tinterval\tlow:high\tslope_low>0\n", options).find("\topen\t"),
              std::string::npos);
    expect_one_line<InputError>([&] { verdicts(header + "a\tvalue\tresults\tx\t{Y}\tinterval\tlow:high\t\n", options); },
                                {"claims.tsv", "row 1", "{Y}", "--set"});
}

TEST_F(ClaimsOfATable, ColumnsAreExpressions) {
    write("results.tsv", "x\tz\tgroup\thalf\n5\t3\ta, b\t1\n6\t\tc\t1\n");
    const std::string header = "\twhere\ttolerance\tinterval";
    EXPECT_EQ(verdict("value\tresults\tx - z\t2\t[group] = 'a, b'\t0.1\t", header), "holds");
    EXPECT_EQ(verdict("value\tresults\tx - z\t2\t[group] = 'a, b'\t0.1\thalf", header), "open");  // 2 ± 1
    EXPECT_EQ(verdict("order\tresults\t1.0 * count(z) / count(*)\t>=0.5\t\t\t", header), "holds");
    EXPECT_EQ(verdict("order\tresults\t1.0 * count(z) / count(*)\t>0.5\t\t\t", header), "differs");
    expect_one_line<InputError>([&] { verdict("value\tresults\t[group]\t2\t\t0.1\t", header); },
                                {"claim 1 (a): \"a, b\"; a number is needed"});
}

TEST_F(ClaimsOfATable, WhatIsNotMeasuredIsOpenOrLeftOut) {
    write("results.tsv", "x\tname\n5\ta\n");
    EXPECT_EQ(verdict("value\tresults\tx\t5\tname = 'b'\t", "\twhere\tneeds"), "open");
    EXPECT_EQ(verdict("value\tresults\tx\t5\tname = 'b'\trows", "\twhere\tneeds"), "");
    // A study with fewer levels has no such column.
    EXPECT_EQ(verdict("order\tresults\ty\t>=0.8\tname\tresults:x\trows", "\tby\tagainst\tneeds"), "");
}

TEST_F(ClaimsOfATable, MarkdownAndHtml) {
    write("results.tsv", "x\n5\n");
    const std::string claims = "claim\tkind\ttable\tcolumn\tpaper\ttolerance\n|a|\tvalue\tresults\tx\t5\t1\n";
    EXPECT_NE(verdicts(claims, {"", {}, ClaimsFormat::markdown}).find("| \\|a\\| | 5 | 5 | +0.0 % | holds |"), std::string::npos);
    EXPECT_NE(verdicts(claims, {"", {}, ClaimsFormat::html}).find("<td>holds</td>"), std::string::npos);
}

TEST_F(ClaimsOfATable, BadClaimsAreOneLine) {
    write("results.tsv", "x\n5\n");
    const auto refused = [&](const std::string& fields, const std::vector<std::string>& parts) {
        expect_one_line<InputError>([&] { verdict(fields); }, parts);
    };
    refused("guess\tresults\tx\t5", {"row 1", "kind \"guess\"", "equality"});
    refused("value\tother\tx\t5", {"claim 1 (a): no such table: other", "results has x"});
    refused("value\tresults\ty\t5", {"claim 1 (a): no such column: y", "results has x"});
    refused("value\tresults\tx\tfive", {"a number as paper or value"});
    refused("order\tresults\tx\tfive", {">=0.5"});
    refused("sign\tresults\tx\tup", {"+ or -"});
    expect_one_line<InputError>([&] { verdict("value\tresults\tx\t5\tquick", "\tspeed"); }, {"unknown column speed"});
    expect_one_line<InputError>([&] { verdict("value\tresults\tx\t5\tfive", "\ttolerance"); }, {"tolerance \"five\""});
    expect_one_line<InputError>([&] { verdict("value\tresults\tx\t5\tx~5", "\twhere"); }, {"claim 1 (a)", "syntax error"});
}

/// The claims of a study on tables of tests/data/claims have the verdicts that the former awk programs gave to these tables.
TEST(ClaimsOfStudies, VerdictsAreAsBefore) {
    const fs::path data = fs::path(GRAINCRACK_TEST_DATA) / "claims";
    int n = 0;
    for (const auto& folder : fs::directory_iterator(data)) {
        const std::string name = folder.path().filename().string();
        const std::string study = name.substr(0, name.rfind('-'));
        std::vector<std::string> files;
        for (const auto& file : fs::directory_iterator(folder)) {
            if (file.path().stem() != "expected") files.push_back(file.path().string());
        }
        const summary::Database tables(files, "");
        const std::string claims = std::string(GRAINCRACK_SOURCE) + "/share/studies/" + study + "/claims.tsv";
        std::map<std::string, std::string> found;
        for (const Claim& claim : read_claims(claims, {{"BTS", "8.8"}, {"TC_LEVEL", "2.744"}})) {
            if (const auto finding = evaluate(claim, tables)) found[claim.name] = name_of(finding->verdict);
        }
        const TableFile expected((folder.path() / "expected.tsv").string());
        const auto names = expected.texts("claim");
        const auto verdicts = expected.texts("verdict");
        for (std::size_t i = 0; i < names.size(); ++i, ++n) EXPECT_EQ(found[names[i]], verdicts[i]) << name << ": " << names[i];
        EXPECT_EQ(found.size(), names.size()) << name;
    }
    EXPECT_GT(n, 150);
}

}  // namespace
}  // namespace graincrack::claims
