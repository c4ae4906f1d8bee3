#include "post/fit/trend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "post/chart/picture.hpp"
#include "post/plot/trend.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

using test::field;

TEST(Trend, LineByHand) {
    // Slope 2.2, intercept 0.7, residual sum 1.8, Sxx 5; t(0.975, 2) = 4.302653
    const std::vector<double> x{0, 1, 2, 3};
    const std::vector<double> y{1, 3, 4, 8};
    const auto trend = fit_trend(x, y, false);
    ASSERT_TRUE(trend.has_value());
    EXPECT_NEAR(trend->coefficient.value, 0.7, 1e-12);
    EXPECT_NEAR(*trend->coefficient.high, 0.7 + 4.302653 * std::sqrt(0.9 * (0.25 + 2.25 / 5)), 1e-5);
    EXPECT_NEAR(*trend->slope.low, 2.2 - 4.302653 * std::sqrt(0.9 / 5), 1e-5);
    EXPECT_NEAR(trend->elasticity.value, 2.2 * 1.5 / 4, 1e-12);
    // Fieller: the ends q are where (4 q − 3.3)² = t² (0.225 q² + 0.18 · 1.5²)
    for (const double q : {trend->elasticity.low.value(), trend->elasticity.high.value()}) {
        EXPECT_NEAR(std::pow(4 * q - 3.3, 2), std::pow(4.302653, 2) * (0.225 * q * q + 0.18 * 2.25), 1e-4);
    }
    EXPECT_LT(*trend->elasticity.low, trend->elasticity.value);
    EXPECT_GT(*trend->elasticity.high, trend->elasticity.value);
    EXPECT_NEAR(trend->at(2).value, 5.1, 1e-12);
    EXPECT_NEAR(*trend->at(2).high, 5.1 + 4.302653 * std::sqrt(0.9 * (0.25 + 0.25 / 5)), 1e-5);
    EXPECT_FALSE(trend->lack_of_fit.has_value());  // nothing is repeated
}

TEST(Trend, PowerLawIsExact) {
    const std::vector<double> x{1, 2, 5};
    std::vector<double> y;
    for (const double v : x) y.push_back(3 * std::pow(v, -0.7));
    const auto trend = fit_trend(x, y, true);
    EXPECT_NEAR(trend->coefficient.value, 3, 1e-12);
    EXPECT_NEAR(trend->elasticity.value, -0.7, 1e-12);
    EXPECT_NEAR(*trend->elasticity.high, -0.7, 1e-6);
    EXPECT_NEAR(trend->at(4).value, 3 * std::pow(4, -0.7), 1e-12);
}

TEST(Trend, RepeatedRowsTestTheStraightLine) {
    // Level means 1, 5, 3: the line is 2 + x
    const std::vector<double> x{0, 0, 1, 1, 2, 2};
    const std::vector<double> y{0.9, 1.1, 4.9, 5.1, 2.9, 3.1};
    const auto trend = fit_trend(x, y, false);
    ASSERT_TRUE(trend->lack_of_fit.has_value());
    // Distances of the level means from 2 + x: −1, 2, −1, twice each: 12 with 1 freedom; pure error 6 · 0.01 with 3
    EXPECT_NEAR(trend->lack_of_fit->f, 12 / (0.06 / 3), 1e-6);
    EXPECT_EQ(trend->lack_of_fit->freedom, 1);
    EXPECT_EQ(trend->lack_of_fit->pure_error_freedom, 3);
    EXPECT_LT(trend->lack_of_fit->p, 0.001);
}

TEST(Trend, WithoutFreedomOrASureMeanThereAreNoIntervals) {
    const auto two = fit_trend(std::vector<double>{1, 2}, std::vector<double>{3, 5}, false);
    EXPECT_NEAR(two->slope.value, 2, 1e-12);
    EXPECT_FALSE(two->slope.low.has_value());
    EXPECT_FALSE(two->elasticity.high.has_value());
    // A mean of y near zero: any ratio is possible.
    const auto zero = fit_trend(std::vector<double>{1, 2, 3, 4}, std::vector<double>{-3, 2, -1, 2.5}, false);
    EXPECT_TRUE(zero->slope.low.has_value());
    EXPECT_FALSE(zero->elasticity.low.has_value());
    EXPECT_FALSE(fit_trend(std::vector<double>{1, 1}, std::vector<double>{3, 5}, false).has_value());
}

class TrendTable : public ::testing::Test {
protected:
    std::string write(const std::string& text) {
        std::ofstream(folder_.file("t.tsv")) << text;
        return folder_.file("t.tsv");
    }
    std::string table_of(const std::string& text, const TrendOptions& options) {
        std::ostringstream out;
        write_trend_table(out, {write(text)}, options, TableFormat::tsv, notes_);
        return out.str();
    }
    test::TemporaryFolder folder_;
    std::ostringstream notes_;
};

const std::string two_groups = "test\tedge\tstrength\npull\t1\t2\nsplit\t1\t9\npull\t2\t4\nsplit\t2\t8\npull\t4\t8\nsplit\t4\t\n";

TEST_F(TrendTable, ARowAGroup) {
    const std::string table = table_of(two_groups, {"edge", "strength", false, {"test"}});
    EXPECT_EQ(test::parse_tsv(table).size(), 3U);
    EXPECT_EQ(field(table, "group"), "pull");
    EXPECT_EQ(field(table, "fit"), "linear");
    EXPECT_EQ(field(table, "slope"), "2");
    EXPECT_NEAR(std::stod(field(table, "intercept")), 0, 1e-12);
    EXPECT_EQ(field(table, "elasticity"), "1");
    EXPECT_EQ(field(table, "levels"), "3");
    EXPECT_EQ(field(table, "group", 1), "split");
    EXPECT_EQ(field(table, "slope", 1), "-1");
    EXPECT_EQ(field(table, "n", 1), "2");
    EXPECT_EQ(field(table, "left_out", 1), "1");
    EXPECT_NE(notes_.str().find("1 rows with an empty edge or strength are left out"), std::string::npos) << notes_.str();
    const std::string power = table_of(two_groups, {"edge", "strength", true, {"test"}});
    EXPECT_EQ(field(power, "slope"), "");
    EXPECT_EQ(field(power, "coefficient"), "2");
    EXPECT_EQ(field(power, "elasticity"), "1");
    EXPECT_EQ(field(power, "elasticity_at_x"), "");
}

TEST_F(TrendTable, RunsWithoutAPeakAreNamed) {
    (void)table_of("edge\tstrength\tpeak_kind\n1\t2\tdrop\n2\t3\tcap\n3\t4\t\n", {"edge", "strength", false, {}});
    EXPECT_NE(notes_.str().find("2 rows are of runs without a peak"), std::string::npos) << notes_.str();
}

TEST_F(TrendTable, WhatCannotBeFittedIsOneLine) {
    const auto refuse = [&](const std::string& text, const TrendOptions& options, const std::string& words) {
        test::expect_one_line<InputError>([&] { (void)table_of(text, options); }, {words});
    };
    refuse(two_groups, {"edge", "force", false, {}}, "no column force");
    refuse(two_groups, {"edge", "strength", false, {"seed"}}, "no column seed");
    refuse("edge\tstrength\n1\t2\n1\t3\n", {"edge", "strength", false, {}}, "no two different edge");
    refuse("edge\tstrength\n1\t\n2\t\n", {"edge", "strength", false, {}}, "no two different edge");
    refuse("edge\tstrength\n0\t2\n1\t3\n", {"edge", "strength", true, {}}, "above zero");
    refuse("edge\tstrength\na\t2\n1\t3\n", {"edge", "strength", false, {}}, "a number is needed");
}

TEST_F(TrendTable, PictureHasALineAGroup) {
    const TrendOptions options{"edge", "strength", false, {"test"}};
    const std::string svg = to_svg(draw_trend(collect_trends({write(two_groups)}, options, notes_), options));
    EXPECT_NE(svg.find("pull: b = 2"), std::string::npos);
    EXPECT_NE(svg.find("split: b = −1"), std::string::npos);
}

}  // namespace
}  // namespace graincrack
