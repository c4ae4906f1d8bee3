// The three tools one after the other, through files and through pipes.
#include <cmath>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Pipeline, FilesAndPipeGiveTheSame) {
    const Shell shell;
    const std::string solve = "graincrack-solve brazilian - --frames 4 " + past_peak;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 --frames 4 -o file.h5" + past_peak + "\n" + make_disc +
               "- | " + solve + " -o - >pipe.h5\n" + make_disc + "- >disc-of-pipe.h5");
    const std::string digest = "graincrack-post info --digest ";
    const std::string specimen = shell.must(digest + "disc.h5 | cut -d' ' -f1");
    EXPECT_EQ(specimen.size(), 65u);
    EXPECT_EQ(specimen, shell.must(digest + "disc-of-pipe.h5 | cut -d' ' -f1"));
    const std::string run = shell.must(digest + "file.h5 | cut -d' ' -f1");
    EXPECT_EQ(run, shell.must(digest + "pipe.h5 | cut -d' ' -f1"));
    EXPECT_EQ(run, shell.must(digest + "- <pipe.h5 | cut -d' ' -f1"));
    EXPECT_NE(run, specimen);
    EXPECT_EQ(shell.must("graincrack-post info --check file.h5 | grep -c datasets"), "1\n");
}

TEST(Pipeline, ThreeToolsOnACompressionTest) {
    const Shell shell;
    const std::string said = shell.must(
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o rectangle.h5\n"
        "graincrack-solve uniaxial rectangle.h5 --material augig-granite --rate 50mm/s --max-strain 0.0003 -o uniaxial.h5 2>&1"
        "\ngraincrack-solve triaxial rectangle.h5 --confining-pressure 4MPa -o triaxial.h5" +
        elastic);
    EXPECT_NE(said.find("; did not fail: largest stress "), std::string::npos) << said;
    EXPECT_NE(shell.must("graincrack-post --quiet strength uniaxial.h5 --format table").find("did not fail"), std::string::npos);
    // Elastic, far from the peak: the modulus of the rock less the compliance of the contacts; few grains scatter.
    EXPECT_NEAR(std::atof(cell(shell.must("graincrack-post moduli uniaxial.h5"), "young_modulus_GPa").c_str()), 24, 4);
    const std::string summary = shell.must("ls uniaxial.h5 triaxial.h5 | graincrack-post strength --summary --files-from -");
    EXPECT_EQ(n_lines(summary), 3);
    EXPECT_NE(summary.find("\t4\t"), std::string::npos) << summary;  // MPa of confining pressure
    EXPECT_EQ(shell.must("find uniaxial.h5 triaxial.h5 -print0 | graincrack-post strength --summary --files-from -"), summary);
    shell.must("graincrack-post cracks --quiet uniaxial.h5 -o maps");
    for (const char* name : {"grains.pvd", "cracks.pvd", "cracks.tsv", "rosette.tsv", "summary.tsv", "counts.tsv", "events.tsv",
                             "fragments.tsv", "fragment-counts.tsv"}) {
        EXPECT_NE(content_of(shell.file(std::string("maps/") + name)), "") << name;
    }
}

// Bonds are ten times as soft in sliding as in opening, so that facets oblique to the load slide more than they open in direct
// tension, although tension breaks them.
TEST(Pipeline, CracksOfDirectTensionAreTensile) {
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 4mm --quiet -o rectangle.h5\n"
        "graincrack-solve tension rectangle.h5 --material augig-granite --mass-scaling selective --frames 0 --quiet -o run.h5\n"
        "graincrack-post cracks --quiet run.h5 -o cracks");
    const std::string strength = shell.must("graincrack-post strength run.h5");
    const double tensile = std::atof(cell(strength, "tensile_cracks").c_str());
    const double shear = std::atof(cell(strength, "shear_cracks").c_str());
    EXPECT_GT(tensile, 3);
    EXPECT_GT(tensile, 4 * shear);
    const auto rows = [&](const std::string& condition) {
        return std::atof(shell
                             .must("awk -F'\\t' 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next } "
                                   "{ o = $at[\"opening_m\"]; s = $at[\"sliding_m\"] } " +
                                   condition + " { ++n } END { print n + 0 }' cracks/cracks.tsv")
                             .c_str());
    };
    EXPECT_GT(rows("s * s > o * o"), rows("s * s <= o * o"));
}

// A straight crack has the toughness √(E' Gf). A crack between grains has more, since its path is longer and since it slides on
// facets that are oblique to the load (1.03 to 1.24 times as much, here and in plates of 80 mm).
TEST(Pipeline, ToughnessOfANotchedPlate) {
    const Shell shell;
    const std::string table = shell.must(
        "graincrack-mesh rectangle --width 40mm --height 80mm --grains 700 --slit 16mm --quiet -o - | graincrack-solve tension "
        "- "
        "--material augig-granite --fracture-energy 57.8J/m2 --mass-scaling selective --frames 0 --quiet -o - | "
        "graincrack-post toughness -");
    EXPECT_NEAR(std::atof(cell(table, "notch_mm").c_str()), 16, 4);
    const double predicted = std::atof(cell(table, "predicted_mode_i_toughness_MPa.m^0.5").c_str());
    EXPECT_NEAR(predicted, std::sqrt(57.8 * 24.7e9 / (1 - 0.24 * 0.24)) * 1e-6,
                0.02);  // E, ν of the assemblage, by contact compliance
    const double ratio = std::atof(cell(table, "mode_i_toughness_MPa.m^0.5").c_str()) / predicted;
    EXPECT_GT(ratio, 0.95);
    EXPECT_LT(ratio, 1.4);
}

// Spans are those between nodes of the boundary. K_IC of a crack along grains is larger than that of a straight one, less so
// where the process zone is no small part of the ligament.
TEST(Pipeline, BendingOfABeamAndAHalfDisc) {
    const Shell shell;
    const std::string bend = "graincrack-solve bend - --material augig-granite --rate-tolerance 0.01 --frames 2 --quiet -o ";
    shell.must("graincrack-mesh beam --length 50mm --height 10mm --edge 2.5mm --quiet -o - | " + bend + "beam.h5\n" +
               "graincrack-mesh half-disc --diameter 60mm --edge 3mm --slit 15mm --quiet -o - | " + bend + "half-disc.h5");
    const std::string beam = shell.must("graincrack-post strength beam.h5 --all-columns");
    EXPECT_EQ(cell(beam, "test"), "bend");
    EXPECT_EQ(cell(beam, "peak_kind"), "drop");
    const double span = std::atof(cell(beam, "span_mm").c_str());
    EXPECT_NEAR(span, 40, 2.5);
    const double load = std::atof(cell(beam, "peak_load_kN/m").c_str());
    EXPECT_NEAR(std::atof(cell(beam, "flexural_strength_MPa").c_str()), 1.5 * load * span / 100, 1e-3);  // 3 F S/(2 H²)
    EXPECT_EQ(cell(beam, "tensile_strength_MPa"), "");
    const std::string half_disc =
        shell.must("graincrack-post strength half-disc.h5 && graincrack-post info --check half-disc.h5");
    EXPECT_EQ(cell(half_disc, "flexural_strength_MPa"), "");
    EXPECT_NE(half_disc.find("platens"), std::string::npos);
    const std::string toughness = shell.must("graincrack-post toughness half-disc.h5");
    EXPECT_NEAR(std::atof(cell(toughness, "notch_mm").c_str()), 15, 1e-3);
    const double ratio = std::atof(cell(toughness, "mode_i_toughness_MPa.m^0.5").c_str()) /
                         std::atof(cell(toughness, "predicted_mode_i_toughness_MPa.m^0.5").c_str());
    EXPECT_GT(ratio, 0.8);
    EXPECT_LT(ratio, 1.4);
    const std::string map = shell.must("graincrack-post plot cracks half-disc.h5 -o map.svg && cat map.svg");
    EXPECT_NE(map.find("Three-point bending"), std::string::npos);
}

}  // namespace
}  // namespace graincrack::test
