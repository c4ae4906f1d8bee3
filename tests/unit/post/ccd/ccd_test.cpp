// Designs of experiment: against the paper's Table 7, Eq 19 and optimum, and planted models.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "post/ccd/design.hpp"
#include "post/ccd/solve.hpp"
#include "post/ccd/tables.hpp"
#include "post/fit/mohr_coulomb.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/normal.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::ccd {
namespace {

using test::Normal;

const std::string table7 = std::string(GRAINCRACK_TEST_DATA) + "/table7.csv";
constexpr double degrees = 180 / std::numbers::pi;

struct Table7 {
    TableFile table{table7};
    Runs runs = read_runs(table, {});
    LinearModel cohesion(const ModelChoice& choice = {}) const { return fit_response(table, runs, "C_MPa", choice); }
    LinearModel friction(const ModelChoice& choice = {}) const { return fit_response(table, runs, "phi_deg", choice); }
    std::vector<Goal> goals() const {
        std::vector<Goal> goals{parse_goal("C_MPa=21", Goal::Kind::target, "--target"),
                                parse_goal("phi_deg=53", Goal::Kind::target, "--target")};
        set_limits(goals[0], table.numbers("C_MPa"));
        set_limits(goals[1], table.numbers("phi_deg"));
        return goals;
    }
    std::vector<Optimum> solve_with(const std::vector<LinearModel>& models) const {
        return solve(models, goals(), Region(runs.coded));
    }
};

void expect_coefficients(const std::string& response, const LinearModel& model, const std::vector<double>& expected,
                         double tolerance) {
    ASSERT_EQ(model.terms.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        test::verify("calibration: " + response + ", term " + model.terms[i].name(),
                     model.coefficients(static_cast<Eigen::Index>(i)), expected[i], tolerance, "Eq 19", 1);
    }
}
void expect_contact(const Table7& paper, const std::vector<Optimum>& optimum, double cohesion, double friction_angle) {
    ASSERT_EQ(optimum.size(), 1U);
    test::verify("calibration: contact cohesion (MPa)", paper.runs.factors[0].value(optimum[0].coded[0]), cohesion, 0.02, "paper",
                 1);
    test::verify("calibration: contact friction angle (deg)", paper.runs.factors[1].value(optimum[0].coded[1]), friction_angle,
                 0.01, "paper", 1);
}

TEST(CcdDesign, IsTheOneOfTable7) {
    const Table7 paper;
    const auto runs = coded_runs(2, Star::rotatable, 5);
    ASSERT_EQ(runs.size(), 13U);
    for (std::size_t i = 0; i < 13; ++i) {
        for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(runs[i][k], paper.runs.coded[i][k], 5e-6) << i;  // printed to 5 digits
    }
    const Factor cohesion{"contact_cohesion_MPa", 30.525, 91.575};
    EXPECT_NEAR(cohesion.value(std::sqrt(2)), 104.22, 0.005);
}

TEST(CcdDesign, HasCountsAndStarsOfItsKind) {
    const auto runs = coded_runs(4, Star::face_centred, 3);
    EXPECT_EQ(runs.size(), 16U + 8U + 3U);
    for (const auto& run : runs) {
        for (double x : run) EXPECT_LE(std::abs(x), 1);
    }
    EXPECT_DOUBLE_EQ(star_distance(Star::rotatable, 4), 2);
    EXPECT_NEAR(star_distance(Star::rotatable, 3), std::pow(8, 0.25), 1e-12);
}

TEST(CcdDesign, HasLeverageOfTheDistanceAloneIfRotatable) {
    const auto runs = coded_runs(3, Star::rotatable, 6);
    const LinearModel model = fit_quadratic(runs, std::vector<double>(runs.size(), 1.0));
    const double r = 1.2;
    const double along = model.leverage({r, 0, 0});
    EXPECT_NEAR(model.leverage({0, -r, 0}), along, 1e-10);
    const double d = r / std::sqrt(3);
    EXPECT_NEAR(model.leverage({d, d, -d}), along, 1e-10);
    EXPECT_GT(std::abs(model.leverage({0, 0, 0}) - along), 0.01);
}

TEST(CcdSolve, HasQuantilesOfFisherForAllFreedoms) {
    EXPECT_NEAR(f_quantile(0.05, 1, 1), 161.4476, 1e-4);  // printed tables
    EXPECT_NEAR(f_quantile(0.05, 3, 12), 3.490295, 1e-6);
    for (const auto& [first, second] : {std::pair{1, 271}, std::pair{5, 572}, std::pair{2, 1000000}}) {
        EXPECT_NEAR(f_tail(f_quantile(0.05, first, second), first, second), 0.05, 1e-12) << first << " " << second;
    }
}

TEST(CcdFit, GivesEquation19OfTable7) {
    const Table7 paper;
    EXPECT_EQ(paper.runs.factors[0].name, "cc_MPa");
    EXPECT_EQ(paper.runs.factors[1].name, "phic_deg");
    // Eq 19 is printed to 0.01 from C and φ as printed to 0.1.
    expect_coefficients("C of rounded values", paper.cohesion(), {11.12, 7.36, -4.94, -7.48, 1.32, 6.89}, 0.006);
    expect_coefficients("phi of rounded values", paper.friction(), {66.98, -4.66, 15.76, 4.78, -0.60, -7.98}, 0.006);
    EXPECT_NEAR(paper.cohesion().r_squared(), 0.969, 0.0005);
    EXPECT_NEAR(paper.friction().r_squared(), 0.944, 0.0005);
    const std::vector<double> errors{1.04, 0.82, 0.82, 1.16, 0.88, 0.88};
    for (std::size_t i = 0; i < errors.size(); ++i) {
        EXPECT_NEAR(paper.cohesion().standard_error(i), errors[i], 0.005) << i;
    }
    const auto lack = paper.cohesion().lack_of_fit();
    ASSERT_TRUE(lack.has_value());
    EXPECT_EQ(lack->freedom, 3);
    EXPECT_EQ(lack->pure_error_freedom, 4);
    EXPECT_NEAR(lack->f, 13.6, 0.05);
    EXPECT_NEAR(lack->p, 0.015, 0.001);  // a unit of its last printed digit: 0.0145 here
}

TEST(CcdFit, GivesTheUnroundedSurfaceOfTheStrengthsOfTable7) {
    const Table7 paper;
    const std::vector<double> confining{0, 4, 8};
    std::vector<double> cohesion, friction;
    const auto s0 = paper.table.numbers("s1_at_0");
    const auto s4 = paper.table.numbers("s1_at_4");
    const auto s8 = paper.table.numbers("s1_at_8");
    for (std::size_t i = 0; i < s0.size(); ++i) {
        const MohrCoulomb line = fit_mohr_coulomb(confining, std::vector<double>{s0[i], s4[i], s8[i]});
        cohesion.push_back(line.cohesion);
        friction.push_back(line.friction_angle * degrees);
        const auto to_tenths = [](double value) { return std::round(value * 10) / 10; };
        test::verify("calibration: Table 7, C of every run rounded (MPa)", to_tenths(line.cohesion),
                     paper.table.numbers("C_MPa")[i], 1e-15, "as printed, to 0.1");
        test::verify("calibration: Table 7, phi of every run rounded (deg)", to_tenths(friction.back()),
                     paper.table.numbers("phi_deg")[i], 1e-15, "as printed, to 0.1");
    }
    const LinearModel C = fit_quadratic(paper.runs.coded, cohesion);
    const LinearModel phi = fit_quadratic(paper.runs.coded, friction);
    expect_coefficients("C of unrounded values", C, {11.098, 7.388, -4.938, -7.467, 1.322, 6.901}, 0.0006);
    expect_coefficients("phi of unrounded values", phi, {66.962, -4.654, 15.738, 4.785, -0.608, -7.955}, 0.0006);
    expect_contact(paper, paper.solve_with({C, phi}), 74.62, 48.77);
}

TEST(CcdSolve, GivesThePapersOptimumOfTable7) {
    const Table7 paper;
    const std::vector<LinearModel> models{paper.cohesion(), paper.friction()};
    const auto optimum = paper.solve_with(models);
    ASSERT_EQ(optimum.size(), 1U);  // the other root, (5.75, 4.51), lies outside the design
    EXPECT_EQ(optimum[0].free_factors, 0U);
    EXPECT_NEAR(optimum[0].desirability, 1, 1e-6);
    EXPECT_NEAR(optimum[0].coded[0], 0.443, 0.0006);
    EXPECT_NEAR(optimum[0].coded[1], -0.533, 0.0006);
    expect_contact(paper, optimum, 74.57, 48.76);
    EXPECT_NEAR(models[0].value({5.75, 4.51}), 21, 0.5);  // it is a root: the coordinates are printed to 0.01
    EXPECT_NEAR(models[1].value({5.75, 4.51}), 53, 0.8);
    EXPECT_FALSE(Region(paper.runs.coded).holds({5.75, 4.51}));
    // "Its 95 % prediction interval is ±6 MPa and ±12°"
    const Estimate C = models[0].prediction(optimum[0].coded);
    const Estimate phi = models[1].prediction(optimum[0].coded);
    EXPECT_NEAR((*C.high - *C.low) / 2, 6, 0.5);
    EXPECT_NEAR((*phi.high - *phi.low) / 2, 12, 0.5);
}

TEST(CcdSolve, GivesAnotherOptimumAfterBackwardElimination) {
    const Table7 paper;
    const auto at = [&](double alpha) {
        const ModelChoice choice{true, alpha};
        const auto optimum = paper.solve_with({paper.cohesion(choice), paper.friction(choice)});
        EXPECT_EQ(optimum.size(), 1U);
        return std::pair{paper.runs.factors[0].value(optimum.at(0).coded[0]),
                         paper.runs.factors[1].value(optimum.at(0).coded[1])};
    };
    EXPECT_EQ(paper.cohesion({true, 0.10}).terms.size(), 5U);  // x1² left out of both
    EXPECT_EQ(paper.friction({true, 0.10}).terms.size(), 5U);
    EXPECT_NEAR(at(0.10).first, 72.67, 0.02);
    EXPECT_NEAR(at(0.10).second, 48.71, 0.01);
    EXPECT_EQ(paper.cohesion({true, 0.05}).terms.size(), 5U);
    EXPECT_EQ(paper.friction({true, 0.05}).terms.size(), 4U);  // and x1 x2 out of φ
    EXPECT_NEAR(at(0.05).first, 70.58, 0.02);
    EXPECT_NEAR(at(0.05).second, 48.29, 0.01);
}

TEST(CcdFit, EliminatesNoParentsOfWhatIsLeft) {
    const auto runs = coded_runs(2, Star::rotatable, 3);
    Normal normal(20140435);
    std::vector<double> response;
    for (const auto& x : runs) response.push_back(5 * x[0] * x[1] + 0.01 * normal());
    const LinearModel reduced = eliminate_backward(fit_quadratic(runs, response), 0.01);
    std::string names;
    for (const SurfaceTerm& term : reduced.terms) names += term.name() + ",";
    EXPECT_EQ(names, "1,x1,x2,x1 x2,");
}

TEST(CcdFit, HasThePressOfLeavingEachRunOut) {
    const Table7 paper;
    const LinearModel model = paper.cohesion();
    double press = 0;
    for (std::size_t i = 0; i < 13; ++i) {
        auto runs = model.factors;
        auto response = model.response;
        runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(i));
        response.erase(response.begin() + static_cast<std::ptrdiff_t>(i));
        const LinearModel without = fit_quadratic(runs, response);
        press += std::pow(model.response[i] - without.value(model.factors[i]), 2);
    }
    EXPECT_NEAR(model.press(), press, 1e-9 * press);
}

TEST(Desirability, IsThatOfDerringerAndSuich) {
    const Goal target = parse_goal("y=10:20:40", Goal::Kind::target, "--target");
    EXPECT_DOUBLE_EQ(target(20), 1);
    EXPECT_DOUBLE_EQ(target(15), 0.5);
    EXPECT_DOUBLE_EQ(target(30), 0.5);
    EXPECT_DOUBLE_EQ(target(41), 0);
    const Goal maximum = parse_goal("y=10:20", Goal::Kind::maximum, "--maximise");
    EXPECT_DOUBLE_EQ(maximum(25), 1);
    EXPECT_DOUBLE_EQ(maximum(12), 0.2);
    const Goal minimum = parse_goal("y=10:20", Goal::Kind::minimum, "--minimise");
    EXPECT_DOUBLE_EQ(minimum(5), 1);
    EXPECT_DOUBLE_EQ(minimum(18), 0.2);
    EXPECT_DOUBLE_EQ(overall_desirability({0.25, 1}), 0.5);
    EXPECT_DOUBLE_EQ(overall_desirability({0, 1}), 0);
}

TEST(CcdSolve, GivesTheNearestToTheCentreOfFewerTargetsThanFactors) {
    const auto runs = coded_runs(3, Star::rotatable, 3);
    std::vector<double> plane, sphere;
    for (const auto& x : runs) {
        plane.push_back(x[0] + 2 * x[1] + 2 * x[2]);
        sphere.push_back(std::pow(x[0] - 2, 2) + x[1] * x[1] + x[2] * x[2]);
    }
    const Region region(runs);
    const LinearModel first = fit_quadratic(runs, plane);
    const LinearModel second = fit_quadratic(runs, sphere);
    const auto target = [](const std::string& text) { return parse_goal(text, Goal::Kind::target, "--target"); };
    const auto on_plane = solve({first}, {target("y=-9:3:9")}, region);
    ASSERT_EQ(on_plane.size(), 1U);
    EXPECT_EQ(on_plane[0].free_factors, 2U);
    // (1, 2, 2)/3: the foot of the normal from the centre, 1 away
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(on_plane[0].coded[k], k == 0 ? 1.0 / 3 : 2.0 / 3, 1e-9);
    const auto on_sphere = solve({second}, {target("y=0:1:20")}, region);
    ASSERT_EQ(on_sphere.size(), 1U);
    EXPECT_NEAR(on_sphere[0].coded[0], 1, 1e-9);  // the point of the unit sphere about (2, 0, 0) that looks to the centre
    EXPECT_NEAR(on_sphere[0].coded[1], 0, 1e-9);
    const auto on_both = solve({first, second}, {target("y=-9:1:9"), target("z=0:1:20")}, region);
    ASSERT_EQ(on_both.size(), 1U);
    EXPECT_EQ(on_both[0].free_factors, 1U);
    EXPECT_NEAR(on_both[0].coded[0], 1, 1e-9);
}

TEST(CcdSolve, FindsAMaximumOnTheBorderOfTheDesign) {
    const auto runs = coded_runs(2, Star::rotatable, 3);
    std::vector<double> response;
    for (const auto& x : runs) response.push_back(x[0] + x[1]);
    const Goal goal = parse_goal("y=-3:3", Goal::Kind::maximum, "--maximise");
    const auto optimum = solve({fit_quadratic(runs, response)}, {goal}, Region(runs));
    ASSERT_EQ(optimum.size(), 1U);
    // The circle of radius √2 has x1 + x2 = 2 at (1, 1).
    EXPECT_NEAR(optimum[0].coded[0], 1, 0.02);
    EXPECT_NEAR(optimum[0].coded[1], 1, 0.02);
    EXPECT_NEAR(optimum[0].desirability, 5.0 / 6, 1e-4);
}

TEST(CcdSolve, WritesEachColumnOfCodedFactorsOnce) {
    const test::TemporaryFolder folder;
    std::ofstream file(folder.file("t.tsv"));
    file << "x1\tx2\ty\n";
    for (const auto& x : coded_runs(2, Star::rotatable, 3)) {
        file << x[0] << '\t' << x[1] << '\t' << x[0] + 2 * x[1] * x[1] << '\n';
    }
    file.close();
    const SolveOptions options{{}, {{"y=1"}, {}, {}}};
    const std::string table = test::written(write_solution, folder.file("t.tsv"), options, TableFormat::tsv);
    test::expect_golden(table.substr(0, table.find('\n')));
}

TEST(CcdRuns, CodeColumnsByGivenFactors) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.file("t.tsv")) << "cc\tphi\ty\n30\t45\t1\n90\t61\t2\n60\t53\t3\n";
    const TableFile table(folder.file("t.tsv"));
    const Runs runs = read_runs(table, {parse_factor("cc=30:90"), parse_factor("phi=45:61")});
    EXPECT_EQ(runs.coded, (std::vector<std::vector<double>>{{-1, -1}, {1, 1}, {0, 0}}));
    test::GoldenRefusals refused;
    refused.add<InputError>("no factors", [&] { (void)read_runs(table, {}); });
    refused.add<UsageError>("a lower edge above the upper", [] { (void)parse_factor("cc=90:30"); });
    const auto fit_few = [] {
        auto few = coded_runs(2, Star::rotatable, 1);
        few.resize(5);
        (void)fit_quadratic(few, std::vector<double>(5, 1.0));
    };
    refused.add<InputError>("too few runs", fit_few);
    const auto target = [](const char* text) { (void)parse_goal(text, Goal::Kind::target, "--target"); };
    refused.add_each<UsageError>({"y", "=3", "y=", "y=1:2", "y=3:2:1", "y=a", "y=1:2:3:4", "y=1;2"}, target);
    Goal outside = parse_goal("y=99", Goal::Kind::target, "--target");
    refused.add<UsageError>("outside of 1 to 3", [&] { set_limits(outside, {1, 2, 3}); });
}

}  // namespace
}  // namespace graincrack::ccd
