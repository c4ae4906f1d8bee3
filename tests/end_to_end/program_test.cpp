// Loading programs from the command line.
#include <cmath>

#include "tests/end_to_end/same_arrays.hpp"
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string solve_bar = "graincrack-solve program bar.h5 --material augig-granite --quiet ";

/// A small bar and a pulse through it.
void lay_out_bar(const Shell& shell) {
    shell.must("graincrack-mesh rectangle --width 40mm --height 10mm --edge 3mm --quiet -o bar.h5");
    write_text(shell.file("pulse.toml"), R"(
name = "pulse"
stages = ["run", "wait"]
boundary.source = { on = "left", pressure = { pulse = "1 MPa", over = "5 us" } }
probe.end.point = ["19 mm", 0]
probe.core.circle = [0, 0, "4 mm"]
stage.run.until = { time = "40 us", end.velocity_x = "0.1 m/s" }
stage.wait.until.time = "5 us"
)");
}

TEST(Programs, RunFromFileToProbe) {
    const Shell shell;
    lay_out_bar(shell);
    shell.must(solve_bar + "--program pulse.toml --damping none -o run.h5");
    const std::string stages = shell.must("graincrack-post history run.h5 --stages");
    EXPECT_EQ(n_lines(stages), 3);
    EXPECT_NE(stages.find("end.velocity_x"), std::string::npos) << stages;
    const std::string probe = shell.must("graincrack-post history run.h5 --probe end");
    EXPECT_EQ(probe.substr(0, probe.find('\n')),
              "time_s\tstep\tdisplacement_x_m\tdisplacement_y_m\tvelocity_x_m/s\tvelocity_y_m/s");
    EXPECT_EQ(n_lines(probe), n_lines(shell.must("graincrack-post history run.h5")));
    EXPECT_EQ(shell.must("graincrack-post history run.h5 --probe core | head -1"),
              "time_s\tstep\tstress_xx_Pa\tstress_xy_Pa\tstress_yy_Pa\tstress_zz_Pa\n");
    const Outcome wrong = shell.run("graincrack-post history run.h5 --probe nobody");
    EXPECT_EQ(wrong.exit_code, 3);
    EXPECT_NE(wrong.err.find("core, end, source"), std::string::npos) << wrong.err;
    // A pipe and three threads give the same result.
    shell.must(
        "graincrack-solve program - --program pulse.toml --damping none --material augig-granite --threads 3 --frames 20 "
        "--quiet -o - <bar.h5 >pipe.h5");
    EXPECT_EQ(shell.must("graincrack-post info --digest pipe.h5 | cut -d' ' -f1"),
              shell.must("graincrack-post info --digest run.h5 | cut -d' ' -f1"));
    EXPECT_NE(shell.must(solve_bar + "--program pulse.toml --damping 0.1 --dry-run").find("max_steps"), std::string::npos);
}

// A standard test is a program: run as such it is the same run, past its peak, with the frame of the peak.
TEST(Programs, AStandardTestIsTheProgramThatItPrints) {
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o rectangle.h5\n"
        "graincrack-mesh disc --diameter 30mm --edge 5mm --quiet -o disc.h5\n"
        "graincrack-mesh half-disc --diameter 40mm --edge 4mm --slit 10mm --quiet -o half-disc.h5");
    const std::string options = " --material augig-granite --quiet ";
    const auto compare = [&](const std::string& test, const std::string& specimen, const std::string& own,
                             const std::string& common) {
        SCOPED_TRACE(test + own);
        const std::string command = "graincrack-solve " + test + " " + specimen + options + common + own;
        shell.must(command + " --print-program >program.toml\n" + command + " -o test.h5\ngraincrack-solve program " + specimen +
                   options + common + " --program program.toml -o program.h5");
        EXPECT_EQ(shell.must("graincrack-post history program.h5"), shell.must("graincrack-post history test.h5"));
        const H5Input program(shell.file("program.h5"));
        const H5Input as_test(shell.file("test.h5"));
        expect_same_arrays(program, as_test, "/cracks");
        ASSERT_EQ(program.children("/frames"), as_test.children("/frames"));
        EXPECT_GT(program.children("/frames").size(), 2U);
        for (const std::string& frame : program.children("/frames")) expect_same_arrays(program, as_test, "/frames/" + frame);
    };
    compare("uniaxial", "rectangle.h5", " --rate-tolerance 0.01", " --mass-scaling none --frames 4 ");
    compare("triaxial", "rectangle.h5", " --confining-pressure 3MPa --rate-tolerance 0.02 --max-strain 0.008", " --frames 4 ");
    compare("tension", "rectangle.h5", " --rate 100mm/s --max-strain 0.002", " --frames 4 ");
    compare("brazilian", "disc.h5", " --rate blocks --block-speed 100mm/s --block-steps 1000 --max-strain 0.004",
            " --plane stress --frames 4 ");
    compare("bend", "half-disc.h5", " --span 25mm --max-strain 0.001 --rate-tolerance 0.02", " --platen-friction 0 --frames 4 ");
}

// Masses are scaled unless something is dynamic, or the user wants otherwise.
TEST(Programs, MassesAreScaledForWhatIsQuasiStatic) {
    const Shell shell;
    lay_out_bar(shell);
    const auto factor = [&](const std::string& command) {
        return std::atof(shell
                             .must("graincrack-solve " + command +
                                   " --material augig-granite --dry-run | "
                                   "awk -F'\t' '$1 == \"mass_scaling_factor\" { print $2 }'")
                             .c_str());
    };
    EXPECT_GT(factor("uniaxial bar.h5"), 10);
    EXPECT_EQ(factor("uniaxial bar.h5 --mass-scaling-factor 30"), 30);
    EXPECT_EQ(factor("uniaxial bar.h5 --mass-scaling none"), 0);
    EXPECT_EQ(factor("uniaxial bar.h5 --damping none"), 0);
    shell.must("graincrack-solve uniaxial bar.h5 --material augig-granite --print-program >press.toml");
    EXPECT_GT(factor("program bar.h5 --program press.toml"), 10);
    EXPECT_EQ(factor("program bar.h5 --program press.toml --damping none"), 0);
    EXPECT_EQ(factor("program bar.h5 --program pulse.toml --damping 0.1"), 0);
    // A run that starts from another keeps its masses; waves cannot start from scaled ones.
    const std::string first =
        "graincrack-solve program bar.h5 --program press.toml --material augig-granite "
        "--frames 0 --save-state --quiet ";
    write_text(shell.file("press.toml"),
               "name = \"press\"\nstages = [\"press\"]\ndamping = 0.8\n[platens]\n[stage.press]\n"
               "platen_speed = \"10 mm/s\"\nuntil.time = \"20 us\"\n");
    shell.must(first + "-o scaled.h5\n" + first + "--mass-scaling none -o plain.h5");
    EXPECT_GT(factor("program bar.h5 --program press.toml --restart scaled.h5"), 10);
    EXPECT_EQ(factor("program bar.h5 --program press.toml --restart plain.h5"), 0);
    const Outcome outcome = shell.run(solve_bar + "--program pulse.toml --damping 0.1 --restart scaled.h5 -o run.h5");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("scaled.h5: has scaled masses, and pulse.toml is dynamic (boundary.source"), std::string::npos)
        << outcome.err;
}

TEST(Programs, ATestOfAHeatedSpecimenTellsSoAndIsTheProgramThatItPrints) {
    const Shell shell;
    const std::string common = "specimen.h5 --material granite-crystals ";
    const std::string test = "graincrack-solve uniaxial " + common + "--heat 150K --cool --max-strain 1e-3 ";
    shell.must("graincrack-mesh rectangle --width 10mm --height 20mm --material granite-crystals --quiet -o specimen.h5");
    const Outcome heated = shell.run(test + "-o run.h5");
    EXPECT_EQ(heated.exit_code, 0);
    EXPECT_NE(heated.err.find("uniaxial: heated by 150 K and cooled before axial loading, with "), std::string::npos)
        << heated.err;
    EXPECT_NE(shell.must("graincrack-post strength --summary run.h5").find("heated by 150 K and cooled"), std::string::npos);
    EXPECT_NE(shell.must("graincrack-post info run.h5").find("  heat                     150 K\n"), std::string::npos);
    shell.must(test + "--print-program >test.toml\ngraincrack-solve program " + common +
               "--program test.toml --quiet -o same.h5");
    EXPECT_EQ(shell.must("graincrack-post history same.h5"), shell.must("graincrack-post history run.h5"));
}

// The pressure is reached first, also where the strain limit is not far above the strain of the isotropic stage (1.1e-3).
TEST(Programs, TheStrainLimitDoesNotCutTheIsotropicStage) {
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o rectangle.h5\n"
        "graincrack-solve triaxial rectangle.h5 --material augig-granite --confining-pressure 40MPa --max-strain 1.3e-3 "
        "--quiet -o run.h5");
    const double stress = std::atof(shell.must("graincrack-post history run.h5 | tail -1 | cut -f7").c_str());
    EXPECT_LE(stress, -40e6 * (1 - 2e-3));  // to what counts as rest
}

TEST(Programs, CanDoWhatTestsCan) {
    const Shell shell;
    shell.must("graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o bar.h5");
    write_text(shell.file("press.toml"), R"(
name = "press"
stages = ["press"]
damping = 0.8
platens.max_strain = "1 %"
[stage.press]
platen_speed = { auto = "together", tolerance = 0.02 }
until.peak_drop = 0.3
)");
    const std::string table = shell.must(solve_bar + "--program press.toml --sensitivity --frames 0 -o run.h5");
    EXPECT_EQ(n_lines(table), 7) << table;
    EXPECT_NE(table.find("a quarter of the mass scaling"), std::string::npos) << table;
    EXPECT_NE(table.find("half the rate"), std::string::npos) << table;
    EXPECT_NE(shell.must(solve_bar + "--program press.toml --dry-run").find("max_steps"), std::string::npos);
    // A stage that must come to rest and does not: one line, no file.
    write_text(shell.file("hasty.toml"), R"(
name = "hasty"
stages = ["hold"]
damping = 0.1
platens.max_strain = "1 %"
[stage.hold]
platen_pressure = { to = "2 MPa", over = "10 us" }
until = { rest = 1e-5, time = "30 us" }
must_end_by = "rest"
)");
    const Outcome hasty = shell.run(solve_bar + "--program hasty.toml -o hasty.h5");
    EXPECT_EQ(hasty.exit_code, 4) << hasty.err;
    EXPECT_EQ(n_lines(hasty.err), 1) << hasty.err;
    EXPECT_NE(hasty.err.find("hasty.toml: stage hold: ended by time, not by rest"), std::string::npos) << hasty.err;
    EXPECT_NE(shell.run("test -e hasty.h5").exit_code, 0);
}

/// The largest shear stress of share/programs/joint-shear.toml on its way forth, MPa; forth.toml is the program without its way
/// back.
double shear_strength_of(const Shell& shell, const std::string& notch, const std::string& program = "forth.toml") {
    shell.must("sed 's/, \"back\"//; /stage.back/,$d' " GRAINCRACK_SOURCE "/share/programs/joint-shear.toml >forth.toml");
    shell.must("graincrack-mesh rectangle --width 40mm --height 20mm --edge 2mm --quiet -o specimen.h5" + notch);
    shell.must(
        "graincrack-solve program specimen.h5 --material augig-granite --contact-friction-angle 20deg --quiet -o shear.h5 "
        "--program " +
        program);
    const std::string force = shell.must(
        "graincrack-post history shear.h5 --probe push | awk -F'\t' 'NR==1 {for (i = 1; i <= NF; ++i) if ($i == "
        "\"force_x_N\") column = i} NR > 1 && $column > most {most = $column} END {print most}'");
    return std::stod(force) / 0.04 * 1e-6;
}

// A notch as long as the specimen is wide is a joint, and programs are found by their names.
TEST(Programs, AJointThroughTheWholeWidthSlidesWhereRockBears) {
    const Shell shell;
    const double joint = shear_strength_of(shell, " --slit 40mm");
    const double rock = shear_strength_of(shell, "");
    EXPECT_NEAR(shear_strength_of(shell, " --slit 40mm --slit-angle 0deg", "joint-shear"), 1.82, 0.1);  // without teeth, 5 %
    EXPECT_GT(joint, 1.8);  // 5 MPa · tan 20°, and the teeth of the joint
    EXPECT_LT(joint, 0.8 * rock);
    const Outcome outcome =
        shell.run("graincrack-solve program specimen.h5 --material augig-granite --program joint-sheer -o x.h5");
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find("program joint-sheer: not found (did you mean joint-shear?)"), std::string::npos) << outcome.err;
}

TEST(Programs, WhatDoesNotFitIsOneLine) {
    const Shell shell;
    lay_out_bar(shell);
    const auto refused = [&](const std::string& options, int exit_code, const std::string& named) {
        const Outcome outcome = shell.run(solve_bar + options + " -o run.h5");
        EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
    };
    refused("--program pulse.toml", 2, "--damping: missing");
    refused("--program pulse.toml --damping 0.8 --mass-scaling selective", 2,
            "--mass-scaling: pulse.toml is dynamic (boundary.source");
    refused("--program pulse.toml --damping 0.8 --sensitivity", 2, "pulse.toml has no [platens]");
    refused("--program none.toml --damping none", 3, "none.toml: cannot be read");
    shell.must("sed 's/\"left\"/\"lefft\"/' pulse.toml >part.toml; sed 's/19 mm/21 mm/' pulse.toml >point.toml");
    refused("--program part.toml --damping none", 3, "part.toml: boundary.source: on: the specimen has no boundary part lefft");
    refused("--program point.toml --damping none", 3, "point.toml: probe.end: the point lies in no element");
    EXPECT_EQ(shell.names(), "bar.h5\npart.toml\npoint.toml\npulse.toml\n");
}

}  // namespace
}  // namespace graincrack::test
