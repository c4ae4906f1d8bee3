// The programs on files of schema 1.
#include <cmath>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string options =
    " --material augig-granite --frames 0 --mass-scaling selective --mass-scaling-factor 90 --rate 600mm/s --max-strain 0.012 "
    "--peak-drop 0.9 --quiet ";

/// specimen.h5, uniaxial.h5 and program.h5 of schema 1, in the folder of a shell.
void unpack(const Shell& shell) {
    for (const std::string name : {"specimen", "uniaxial", "program"}) {
        shell.must("gzip -dc " GRAINCRACK_TEST_DATA "/schema-1-" + name + ".h5.gz >" + name + ".h5");
    }
}

double number(const std::string& table, const std::string& column) { return std::atof(cell(table, column).c_str()); }

/// The header of a table and its last row.
std::string last_row(const Shell& shell, const std::string& run) {
    return shell.must("graincrack-post history " + run + " | sed -n '1p;$p'");
}

TEST(Schema1, TablesAndReportOfARun) {
    const Shell shell;
    unpack(shell);
    EXPECT_NE(shell.must("graincrack-post info --check uniaxial.h5").find("run, schema 1"), std::string::npos);
    EXPECT_EQ(n_lines(shell.must("graincrack-post history uniaxial.h5")), 54);
    EXPECT_NEAR(number(last_row(shell, "uniaxial.h5"), "energy_balance_error"), -7.25e-6, 1e-8);
    EXPECT_NE(shell.must("graincrack-post history program.h5 --stages").find("strain limit"), std::string::npos);
    const std::string strength = shell.must("graincrack-post strength uniaxial.h5");
    EXPECT_NEAR(number(strength, "peak_compressive_stress_MPa"), 309.0816, 1e-3);
    EXPECT_NEAR(number(strength, "energy_balance_error"), 7.25033e-06, 1e-10);
    EXPECT_EQ(cell(strength, "peak_kind"), "cap");
    shell.must("graincrack-post report uniaxial.h5 -o page.html");
    EXPECT_NE(shell.must("cat page.html").find("energy balance residual"), std::string::npos);
}

// Its runs do not say when points broke: what counts failed points works, what counts broken ones says what is missing.
TEST(Schema1, CracksByTheLabelsThatARunKnows) {
    const Shell shell;
    unpack(shell);
    const std::string strength = shell.must("graincrack-post strength uniaxial.h5");
    EXPECT_GT(number(strength, "shear_cracks"), 0);
    EXPECT_EQ(number(strength, "tensile_cracks_by_displacement") + number(strength, "shear_cracks_by_displacement"),
              number(strength, "tensile_cracks") + number(strength, "shear_cracks"));
    EXPECT_EQ(cell(strength, "shear_cracks_broken"), "");
    EXPECT_EQ(cell(shell.must("graincrack-post moduli uniaxial.h5"), "crack_initiation_count_damage_90_MPa"), "");
    shell.must("graincrack-post plot rosette uniaxial.h5 --crack-mode displacement -o rosette.svg");
    shell.must("graincrack-post plot cracks uniaxial.h5 -o cracks.svg");
    for (const std::string command : {"plot cracks uniaxial.h5 -o cracks.svg", "plot rosette uniaxial.h5 -o rosette.svg",
                                      "plot counts uniaxial.h5 -o counts.svg", "plot curve uniaxial.h5 -o curve.svg",
                                      "cracks uniaxial.h5 -o folder", "report uniaxial.h5 -o page.html"}) {
        const Outcome outcome = shell.run("graincrack-post " + command + " --quiet --crack-event broken");
        EXPECT_EQ(outcome.exit_code, 3) << command;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        EXPECT_NE(outcome.err.find("uniaxial.h5: has no /cracks/time_broken"), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find("--crack-event failed"), std::string::npos) << outcome.err;
    }
}

// A set of runs of both schemas, on a specimen of schema 1.
TEST(Schema1, AnEnvelopeWithRunsOfSchema2) {
    const Shell shell;
    unpack(shell);
    shell.must("graincrack-solve uniaxial specimen.h5" + options + "-o again.h5\ngraincrack-solve triaxial specimen.h5" +
               options + "--confining-pressure 20MPa -o triaxial.h5");
    const std::string again = shell.must("graincrack-post strength again.h5");
    // The largest stress depends on how grains slide, and has changed with it since schema 1 by 0.5 %.
    EXPECT_NEAR(number(again, "peak_compressive_stress_MPa"), 309.1, 0.02 * 309.1);
    const std::string envelope = shell.must("graincrack-post envelope uniaxial.h5 triaxial.h5 --capped accept 2>/dev/null");
    EXPECT_EQ(cell(envelope, "runs_at_strain_limit"), "2") << envelope;
}

TEST(Schema1, AProgramContinuesARun) {
    const Shell shell;
    unpack(shell);
    write_text(shell.file("unload.toml"), R"(
name = "unload"
stages = ["unload"]
row_every = "20 us"
damping = 0.8
[platens]
max_strain = 0.03
[boundary.membrane]
on = ["left", "right"]
[stage.unload]
membrane.pressure = "keep"
platen_speed = { to = "-0.2 m/s", over = "0.05 ms" }
until.time = "0.1 ms"
)");
    const std::string solve =
        "graincrack-solve program specimen.h5 --material augig-granite --frames 0 --mass-scaling selective "
        "--mass-scaling-factor 90 --quiet ";
    shell.must(solve + "--program unload.toml --restart program.h5 -o unload.h5");
    const std::string before = last_row(shell, "program.h5");
    const std::string after = shell.must("graincrack-post history unload.h5");
    for (const std::string column : {"time_s", "step", "axial_strain", "lateral_strain", "axial_stress_Pa", "energy_external_J",
                                     "energy_contact_J", "energy_friction_J", "shear_cracks"}) {
        const double expected = number(before, column);
        EXPECT_NEAR(number(after, column), expected, 1e-9 * std::abs(expected)) << column;
    }
    const std::string end = last_row(shell, "unload.h5");
    EXPECT_NEAR(number(end, "confining_pressure_Pa"), 1e6, 1e3);  // "keep": the membrane's pressure is in the state
    EXPECT_LT(std::abs(number(end, "energy_balance_error")), 1e-3);
    EXPECT_EQ(shell.must("graincrack-post info unload.h5 | grep schema | xargs"), "kind run, schema 3\n");
}

// The run gets the stop reason of a checkpoint.
TEST(Schema1, ACheckpointIsRefused) {
    const Shell shell;
    unpack(shell);
    write_text(shell.file("rename.py"),
               "import h5py\nwith h5py.File('program.h5', 'r+') as run:\n"
               "    run['run'].attrs['stop_reason'] = b'checkpoint'\n");
    shell.must("/usr/bin/python3 rename.py");
    write_text(shell.file("any.toml"),
               "name = \"any\"\ndamping = 0.8\nstages = [\"wait\"]\n[stage.wait]\nuntil.time = \"1 us\"\n");
    const Outcome outcome = shell.run("graincrack-solve program specimen.h5" + std::string(" --material augig-granite --quiet ") +
                                      "--mass-scaling selective --mass-scaling-factor 90 --program any.toml --restart "
                                      "program.h5 -o run.h5");
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("program.h5: is a checkpoint of schema 1"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace graincrack::test
