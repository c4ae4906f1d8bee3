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

TEST(Pipeline, OneLineFromShapeToStrength) {
    const Shell shell;
    const std::string table =
        shell.must(make_disc + "- | graincrack-solve brazilian - -o -" + past_peak + " | graincrack-post strength -");
    EXPECT_EQ(n_lines(table), 2);
    EXPECT_EQ(cell(table, "test"), "brazilian");
    EXPECT_EQ(cell(table, "grains"), "60");
    EXPECT_GT(std::atof(cell(table, "tensile_strength_MPa").c_str()), 1);
    EXPECT_GT(std::atof(cell(table, "tensile_cracks").c_str()), 0);
    EXPECT_EQ(shell.names(), "");
}

TEST(Pipeline, ThreeToolsOnACompressionTest) {
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o rectangle.h5\n"
        "graincrack-solve uniaxial rectangle.h5 --material augig-granite --rate 50mm/s --max-strain 0.0003 --quiet -o uniaxial.h5"
        "\ngraincrack-solve triaxial rectangle.h5 --confining-pressure 4MPa -o triaxial.h5" +
        elastic);
    const std::string table = shell.must("graincrack-post moduli uniaxial.h5");
    // Elastic, far from the peak: the modulus of the rock less the compliance of the contacts; few grains scatter.
    EXPECT_NEAR(std::atof(cell(table, "young_modulus_GPa").c_str()), 24, 4);
    EXPECT_EQ(cell(shell.must("graincrack-post strength triaxial.h5"), "confining_pressure_MPa"), "4");
    shell.must(
        "graincrack-post plot curve uniaxial.h5 triaxial.h5 -o curve.png\ngraincrack-post plot cracks uniaxial.h5 -o cracks.png\n"
        "graincrack-post plot specimen rectangle.h5 -o specimen.svg\ngraincrack-post cracks --quiet uniaxial.h5 -o maps");
    EXPECT_EQ(content_of(shell.file("curve.png")).substr(1, 3), "PNG");
    EXPECT_EQ(content_of(shell.file("cracks.png")).substr(1, 3), "PNG");
    EXPECT_NE(content_of(shell.file("specimen.svg")).find("<svg"), std::string::npos);
    shell.must(
        "ls uniaxial.h5 triaxial.h5 | graincrack-post strength --summary --files-from - >summary.tsv\n"
        "graincrack-post report --quiet uniaxial.h5 triaxial.h5 --capped accept -o page.html");
    EXPECT_NE(content_of(shell.file("page.html")).find("Quality checks"), std::string::npos);
    EXPECT_EQ(n_lines(content_of(shell.file("summary.tsv"))), 3);
    for (const char* name : {"grains.pvd", "cracks.pvd", "cracks.tsv", "rosette.tsv", "summary.tsv", "counts.tsv", "events.tsv",
                             "fragments.tsv", "fragment-counts.tsv"}) {
        EXPECT_NE(content_of(shell.file(std::string("maps/") + name)), "") << name;
    }
}

TEST(Pipeline, FirstPeaksAndResidualStrengthsOfTestsThatGoOn) {
    const Shell shell;
    const std::string test =
        " rectangle.h5 --material augig-granite --contact-friction-angle 25deg --rate 50mm/s --max-strain 0.014 --frames 0 "
        "--quiet ";
    shell.must(
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 4mm --quiet -o rectangle.h5\ngraincrack-solve uniaxial" +
        test + "-o falls.h5\ngraincrack-solve uniaxial" + test +
        "--peak-drop none -o goes-on.h5\n"
        "for p in 1 3; do graincrack-solve triaxial --confining-pressure ${p}MPa --peak-drop none" +
        test + "-o triaxial$p.h5; done");
    EXPECT_NE(shell.must("graincrack-post info falls.h5").find("peak drop"), std::string::npos);
    EXPECT_NE(shell.must("graincrack-post info goes-on.h5").find("strain limit"), std::string::npos);
    const auto number = [&](const std::string& run, const char* column) {
        return std::atof(cell(shell.must("graincrack-post strength " + run), column).c_str());
    };
    const double largest = number("falls.h5", "peak_compressive_stress_MPa");
    EXPECT_NEAR(number("falls.h5", "first_peak_MPa"), largest, 0.01 * largest);
    EXPECT_EQ(cell(shell.must("graincrack-post strength falls.h5"), "residual_MPa"), "");
    EXPECT_EQ(number("goes-on.h5", "first_peak_MPa"), number("falls.h5", "first_peak_MPa"));
    EXPECT_GT(number("goes-on.h5", "drop_percent"), 50);
    EXPECT_GT(number("triaxial3.h5", "residual_MPa"), number("goes-on.h5", "residual_MPa") + 3);

    const std::string envelope = "graincrack-post envelope falls.h5 triaxial1.h5 triaxial3.h5 --strength ";
    const std::string by_first_peak = shell.must(envelope + "first-peak");
    EXPECT_EQ(cell(by_first_peak, "runs"), "3");
    const Outcome residual = shell.run(envelope + "residual");
    EXPECT_EQ(residual.exit_code, 0);
    EXPECT_EQ(cell(residual.out, "strength"), "residual");
    EXPECT_EQ(cell(residual.out, "runs"), "2");
    EXPECT_EQ(cell(residual.out, "compression_runs"), "3");
    EXPECT_LT(std::atof(cell(residual.out, "cohesion_MPa").c_str()), std::atof(cell(by_first_peak, "cohesion_MPa").c_str()));
    EXPECT_EQ(n_lines(residual.err), 1) << residual.err;
    EXPECT_NE(residual.err.find("falls.h5: no residual strength"), std::string::npos) << residual.err;
    shell.must("graincrack-post --quiet plot envelope goes-on.h5 triaxial1.h5 triaxial3.h5 --strength residual -o residual.svg");
    EXPECT_NE(content_of(shell.file("residual.svg")).find("residual strength"), std::string::npos);
}

// Broken points are some of the failed ones, in tables, maps and pictures alike.
TEST(Pipeline, CracksByEventAndMode) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 --frames 4 -o run.h5" + past_peak);
    const std::string strength = shell.must("graincrack-post strength run.h5");
    const auto sum = [](const std::string& table, const std::string& ending) {
        return std::atof(cell(table, "tensile_cracks" + ending).c_str()) +
               std::atof(cell(table, "shear_cracks" + ending).c_str());
    };
    const double failed = sum(strength, "");
    EXPECT_GT(failed, 0);
    EXPECT_EQ(sum(strength, "_by_sign"), failed);
    EXPECT_LE(sum(strength, "_broken"), failed);
    EXPECT_EQ(sum(strength, "_broken_by_sign"), sum(strength, "_broken"));
    shell.must(
        "graincrack-post cracks --quiet run.h5 -o failed\n"
        "graincrack-post cracks --quiet run.h5 --crack-event broken --crack-mode sign -o broken");
    const std::string summary = content_of(shell.file("failed/summary.tsv"));
    const std::string end = shell.must("sed -n '1p;$p' failed/summary.tsv");
    EXPECT_GT(sum(end, "_broken"), 0);
    EXPECT_LE(sum(end, "_broken"), sum(end, ""));
    EXPECT_EQ(sum(content_of(shell.file("broken/summary.tsv")), ""), sum(summary, "_broken"));
    EXPECT_EQ(content_of(shell.file("broken/cracks.tsv")), content_of(shell.file("failed/cracks.tsv")));
    EXPECT_NE(content_of(shell.file("broken/counts.tsv")), content_of(shell.file("failed/counts.tsv")));
    EXPECT_NE(shell.must("grep -c crack_label broken/cracks_0001.vtp"), "0\n");
    shell.must("graincrack-post plot cracks run.h5 --crack-event broken --crack-mode sign -o map.svg");
    EXPECT_NE(content_of(shell.file("map.svg")).find("tensile: open then"), std::string::npos);
    const Outcome outcome = shell.run("graincrack-post plot cracks run.h5 --crack-event split -o map.svg");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("failed|half-damaged|broken"), std::string::npos) << outcome.err;
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

// Under pressure a point of this law passes the peak of its cohesion long before its strength is gone.
TEST(Pipeline, ALawWithFrictionBesideCohesionCountsWhatIsLost) {
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 4mm --quiet -o rectangle.h5\n"
        "graincrack-solve uniaxial rectangle.h5 --material augig-granite --contact-law cohesive-frictional "
        "--contact-tensile-strength 8MPa --contact-cohesion 38MPa --contact-friction-angle 45deg --mode-ii-fracture-energy "
        "1500J/m2 --contact-open-shear-strength 30MPa "
        "--mass-scaling selective --rate 50mm/s --frames 2 --quiet -o run.h5\n"
        "graincrack-post cracks --quiet run.h5 -o lost\n"
        "graincrack-post cracks --quiet run.h5 --crack-event failed -o failed");
    const auto at_peak = [&](const std::string& folder) {
        const std::string summary = content_of(shell.file(folder + "/summary.tsv"));
        return std::atof(cell(summary, "tensile_cracks").c_str()) + std::atof(cell(summary, "shear_cracks").c_str());
    };
    const double lost = at_peak("lost");
    EXPECT_GT(lost, 0);
    EXPECT_GT(at_peak("failed"), 3 * lost);
    const std::string strength = shell.must("graincrack-post strength run.h5");
    EXPECT_EQ(std::atof(cell(strength, "tensile_cracks").c_str()) + std::atof(cell(strength, "shear_cracks").c_str()), lost);
    const std::string moduli = shell.must("graincrack-post moduli run.h5");
    EXPECT_EQ(cell(moduli, "crack_initiation_count_MPa"), cell(moduli, "crack_initiation_count_damage_50_MPa"));
    shell.must("graincrack-post plot cracks run.h5 --frame peak -o map.svg");
    EXPECT_NE(content_of(shell.file("map.svg")).find("50 % of cohesion left"), std::string::npos);
}

// A straight crack has the toughness √(E' Gf). A crack between grains has more, since its path is longer and since it slides on
// facets that are oblique to the load (1.03 to 1.24 times as much, here and in plates of 80 mm).
TEST(Pipeline, ToughnessOfANotchedPlate) {
    const Shell shell;
    const std::string table = shell.must(
        "graincrack-mesh rectangle --width 40mm --height 80mm --grains 700 --notch 16mm --quiet -o - | graincrack-solve tension "
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
    const std::string beam = shell.must("graincrack-post strength beam.h5");
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

TEST(Threads, SameContentForAnyNumberPastThePeak) {
    const Shell shell;
    // large enough for three threads
    shell.must("graincrack-mesh disc --diameter 30mm --grains 800 --quiet -o disc.h5");
    std::string first;
    for (const char* threads : {"1", "2", "3"}) {
        shell.must("graincrack-solve brazilian disc.h5 -o run.h5 --threads " + std::string(threads) + past_peak);
        const std::string digest = shell.must("graincrack-post info --digest run.h5");
        if (first.empty()) first = digest;
        EXPECT_EQ(digest, first) << threads << " threads";
    }
    // The comparison covers the whole law only if there are cracks and the stress has dropped.
    const std::string strength = shell.must("graincrack-post strength run.h5");
    const std::string last = shell.must("graincrack-post history run.h5 | sed -n '1p;$p'");
    EXPECT_GT(std::atof(cell(strength, "tensile_cracks").c_str()), 3);
    EXPECT_LT(std::atof(cell(strength, "strain_at_peak").c_str()), 0.99 * -std::atof(cell(last, "axial_strain").c_str()));
}

}  // namespace
}  // namespace graincrack::test
