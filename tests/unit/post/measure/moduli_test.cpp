#include "post/measure/moduli.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/golden.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

using test::field;
using test::number_in;
using test::Recipe;

std::string table_of(const Recipe& recipe, ColumnChoice columns = ColumnChoice::all, TableFormat format = TableFormat::tsv) {
    const test::TemporaryFolder folder;
    std::ostringstream notes;
    test::write_run(folder.file("run.h5"), recipe);
    return test::written(write_moduli_table, std::vector{folder.file("run.h5")}, format, notes, columns);
}

TEST(Moduli, HaveColumnsForScriptsAndATableForTheTerminal) {
    const std::string usual = table_of({}, ColumnChoice::usual);
    test::expect_golden(usual.substr(0, usual.find('\n')), "columns");
    test::expect_golden(test::narrow(table_of({}, ColumnChoice::all, TableFormat::aligned)));  // 24.62 is 26 (1 − (0.3/1.3)²)
    EXPECT_EQ(field(table_of({}), "plane"), "strain");
}

TEST(Moduli, AreConvertedFromPlaneStrain) {
    const std::string table = table_of({.yield_share = 0.6});  // what happens beyond half the peak does not matter
    EXPECT_NEAR(number_in(table, "plane_young_modulus_GPa"), 26, 1e-5);
    EXPECT_NEAR(number_in(table, "plane_poisson_ratio"), 0.3, 1e-6);
    EXPECT_NEAR(number_in(table, "poisson_ratio"), 0.3 / 1.3, 1e-6);                              // ν = ν'/(1+ν')
    EXPECT_NEAR(number_in(table, "young_modulus_GPa"), 26 * (1 - std::pow(0.3 / 1.3, 2)), 1e-5);  // E = E'(1−ν²)
    EXPECT_NEAR(number_in(table, "platen_young_modulus_GPa"), 26 / 1.02 * (1 - std::pow(0.3 / 1.3, 2)), 1e-5);
}

TEST(Moduli, HaveCaveatsInTheirRow) {
    EXPECT_EQ(field(table_of({}), "warning"), "");  // the platens see 2 % more strain
    Recipe recipe{.platen_compliance = 1.1, .drop = 0, .stop_reason = "strain limit"};
    test::expect_golden(field(table_of(recipe), "warning"));
    recipe.test = "brazilian";
    EXPECT_EQ(field(table_of(recipe), "warning"), "");  // no moduli
}

TEST(Moduli, AreOfThePartOfTheCurveOfTheirConvention) {
    const std::string table = table_of({.yield_share = 0.5, .rows = 1001});  // beyond half the peak the tangent is half of 26 GPa
    EXPECT_NEAR(number_in(table, "plane_young_modulus_GPa"), 26, 1e-4);
    // Rows are even in stress y ∈ [−1, 1] about the bend, strain x = y before and 2y after it: cov(x, y) = 1/2,
    // var(x) = 5/6 − 1/16.
    const double expected = 26 * 0.5 / (5.0 / 6 - 1.0 / 16);
    EXPECT_NEAR(number_in(table, "plane_tangent_young_modulus_GPa"), expected, 0.05);
    EXPECT_NEAR(number_in(table, "plane_average_young_modulus_GPa"), expected, 0.05);
    EXPECT_NEAR(number_in(table, "plane_secant_young_modulus_GPa"), 26 / 1.5, 1e-3);
    EXPECT_NEAR(number_in(table, "plane_secant_poisson_ratio"), 0.3, 1e-6);
    EXPECT_NEAR(number_in(table, "secant_young_modulus_GPa"), 26 / 1.5 * (1 - std::pow(0.3 / 1.3, 2)), 1e-3);
}

TEST(Brittleness, IsTheFallOverTheChord) {
    const std::string table = table_of({});  // falls by half its 125 MPa while the strain grows by 0.2 of that at the peak
    EXPECT_EQ(field(table, "peak_kind"), "drop");
    // Both slopes are by the platens: (0.5 · 125)/(0.2 · ε_peak) over 125/ε_peak
    EXPECT_NEAR(number_in(table, "post_peak_slope_over_young_modulus"), 2.5, 1e-6);
    EXPECT_EQ(field(table_of({.drop = 0.1, .stop_reason = "strain limit"}), "post_peak_slope_over_young_modulus"), "");
}

TEST(Moduli, AreThoseOfOtherTestsAndPlanes) {
    const Recipe stress{.plane = PlaneCondition::stress};
    // Its isotropic stage has another slope: 20 MPa over 1e-4.
    const Recipe triaxial{.test = "triaxial", .confining_pressure = 20e6};
    for (const Recipe& recipe : {stress, triaxial, Recipe{.test = "tension", .peak = 6e6}}) {
        const std::string table = table_of(recipe);
        EXPECT_NEAR(number_in(table, "plane_young_modulus_GPa"), 26, 1e-5) << recipe.test;
        EXPECT_NEAR(number_in(table, "plane_poisson_ratio"), 0.3, 1e-6) << recipe.test;
    }
    const std::string unconverted = table_of(stress);
    EXPECT_EQ(field(unconverted, "young_modulus_GPa"), field(unconverted, "plane_young_modulus_GPa"));
    EXPECT_EQ(field(unconverted, "poisson_ratio"), field(unconverted, "plane_poisson_ratio"));
    const std::string brazilian = table_of({.test = "brazilian", .peak = 6e6});  // has none but a prediction
    EXPECT_EQ(field(brazilian, "young_modulus_GPa") + field(brazilian, "platen_young_modulus_GPa"), "");
    EXPECT_NE(field(brazilian, "predicted_young_modulus_GPa"), "");
}

TEST(GrainModuli, AreMeansByAreaOfThePhases) {
    Specimen specimen = test::grid_specimen(2, 5, 0.02, 0.05);  // 20 grains of equal areas
    specimen.phase_names = {"quartz", "feldspar", "mica"};
    for (std::size_t g = 0; g < 20; ++g) specimen.grain_phase[g] = g < 6 ? 0 : g < 18 ? 1 : 2;
    RunHeader header = test::synthetic_header({});
    header.plane = PlaneCondition::stress;
    header.fabric = uniform_fabric(header.rock, header.contact, 3);
    const std::array young{36.12e9, 24.51e9, 10.32e9};
    for (std::size_t p = 0; p < 3; ++p) header.fabric.phases[p].young_modulus = young[p];
    header.fabric.phases[2].poisson_ratio = 0.33;
    const GrainModuli grains = grain_moduli(header, specimen);
    EXPECT_NEAR(grains.voigt, 26.574e9, 1e3);    // 0.3 · 36.12 + 0.6 · 24.51 + 0.1 · 10.32
    EXPECT_NEAR(grains.reuss, 23.54305e9, 1e4);  // 1/(0.3/36.12 + 0.6/24.51 + 0.1/10.32)
    EXPECT_NEAR(grains.poisson_ratio, 0.9 * 0.23 + 0.1 * 0.33, 1e-12);
    // Very stiff contacts leave Hill's mean.
    for (ContactParameters& contact : header.fabric.contacts) contact.normal_stiffness = contact.shear_stiffness = 1e30;
    EXPECT_NEAR(predict_moduli(header, specimen).young_modulus, 0.5 * (26.574e9 + 23.54305e9), 1e4);
    const std::string table = table_of({});  // one phase
    EXPECT_DOUBLE_EQ(number_in(table, "voigt_young_modulus_GPa"), 25.8);
    EXPECT_DOUBLE_EQ(number_in(table, "reuss_young_modulus_GPa"), 25.8);
}

TEST(Moduli, ArePredictedByTheContactLengthOfTheSpecimen) {
    const Specimen specimen = test::grid_specimen(4, 4, 0.04, 0.04);
    // 3 inner lines each way of 0.04 m, and 16 diagonals of √2 cm
    const double density = (6 * 0.04 + 16 * std::sqrt(2) * 0.01) / (0.04 * 0.04);
    EXPECT_NEAR(contact_length_per_area(specimen), density, 1e-9 * density);
    const RunHeader header = test::synthetic_header({.plane = PlaneCondition::stress});
    const fpz::AssemblageModuli moduli = predict_moduli(header, specimen);
    const double kn = header.contact.normal_stiffness;
    const double ks = header.contact.shear_stiffness;
    const double expected = 1 / (1 / 25.8e9 + density * (3 / (8 * kn) + 1 / (8 * ks)));
    EXPECT_NEAR(moduli.young_modulus, expected, 1e-9 * expected);
    EXPECT_LT(expected, 25.8e9);
}

}  // namespace
}  // namespace graincrack
