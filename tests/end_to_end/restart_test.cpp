// Runs that continue from a saved state.
#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/end_to_end/same_arrays.hpp"
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

/// Compression under pressure past the peak, in two stages, as one run and as two.
const std::string head = R"(
name = "compress"
damping = 0.8
row_every = "2 us"
[platens]
[boundary.membrane]
on = ["left", "right"]
)";
const std::string confine = R"(
[stage.confine]
membrane.pressure = { to = "2 MPa", over = "0.1 ms" }
platen_pressure = { to = "2 MPa", over = "0.1 ms" }
until.time = "0.15 ms"
)";
const std::string compress = R"(
[stage.compress]
platen_speed = { to = "1 m/s", over = "0.05 ms" }
until.time = "0.3 ms"
)";
const std::string crush = R"(
[stage.crush]
membrane.pressure = "keep"
platen_speed = { to = "1.2 m/s", over = "0.05 ms" }
until.time = "0.2 ms"
)";

const std::string press = R"(
[stage.press]
platen_speed = { auto = "together", tolerance = 0.02 }
until = { peak_drop = 0.2, time = "0.5 ms" }
)";

void lay_out_program(const Shell& shell) {
    shell.must("graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o specimen.h5");
    const auto write = [&](const std::string& name, const std::string& stages, const std::string& tables) {
        write_text(shell.file(name), "stages = " + stages + head + tables);
    };
    write("whole.toml", R"(["confine", "compress", "crush"])", confine + compress + crush);
    write("first.toml", R"(["confine", "compress"])", confine + compress);
    write("second.toml", R"(["crush"])", crush);
    // More than an attribute of HDF5 can have.
    write("auto.toml", R"(["confine", "press"])", confine + press + "# " + std::string(100'000, 'x') + "\n");
}
const std::string solve_program =
    "graincrack-solve program specimen.h5 --material augig-granite --quiet --save-state --frames 0 ";

/// Makes the material one of three phases, with contacts of a pair and strengths that scatter, and the specimen of it.
void make_phases(const Shell& shell) {
    write_text(shell.file("phases.toml"), R"(
[phases]
quartz = { fraction = 0.4, relative_young_modulus = 1.4 }
feldspar = { fraction = 0.4 }
mica = { fraction = 0.2, relative_young_modulus = 0.4, density = "3000 kg/m3" }
[pairs]
quartz-mica = { tensile_strength = "12 MPa", cohesion = "40 MPa" }
heterophase = { friction_angle = 0.8 }
[strength]
modulus = 5
)");
    shell.must(
        "cat " GRAINCRACK_SOURCE
        "/share/materials/augig-granite.toml phases.toml >augig-granite.toml\n"
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet --material augig-granite.toml -o specimen.h5");
}

// Three phases with scaled masses; the law whose friction weakens with real masses.
TEST(Restart, GoesOnToTheByte) {
    const std::string frictional = "--mass-scaling none --contact-law cohesive-frictional --contact-cohesion 14MPa ";
    for (const std::string& options : {std::string(), frictional}) {
        const Shell shell;
        lay_out_program(shell);
        if (options.empty()) make_phases(shell);
        const std::string solve = "export GRAINCRACK_MATERIALS=.\n" + solve_program + options;
        shell.must(solve + "--program whole.toml -o whole.h5\n" + solve + "--program first.toml -o first.h5\n" + solve +
                   "--threads 2 --program second.toml --restart first.h5 -o second.h5");
        const auto rows = [&](const std::string& run) { return shell.must("graincrack-post history " + run + " | tail -n +2"); };
        const std::string first = rows("first.h5");
        const std::string second = rows("second.h5");
        // The second run begins with the state in which the first one ended.
        EXPECT_EQ(first + second.substr(second.find('\n') + 1), rows("whole.h5"));
        EXPECT_GT(n_lines(second), 50);
        EXPECT_GT(std::atof(cell(shell.must("graincrack-post strength second.h5"), "shear_cracks").c_str()), 0);
        expect_same_arrays(H5Input(shell.file("second.h5")), H5Input(shell.file("whole.h5")), "/state");
        expect_same_arrays(H5Input(shell.file("second.h5")), H5Input(shell.file("whole.h5")), "/cracks");
    }
}

TEST(Restart, ARunStopsInItsWallTimeAndGoesOn) {
    const Shell shell;
    shell.must("graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o specimen.h5");
    const std::string test = "graincrack-solve uniaxial specimen.h5 --material augig-granite --frames 2 ";
    shell.must(test + "--quiet -o whole.h5");
    const Outcome stopped = shell.run(test + "--walltime 50ms -o run.h5");
    EXPECT_EQ(stopped.exit_code, 143);
    EXPECT_NE(stopped.err.find("--restart run.h5.checkpoint resumes it"), std::string::npos) << stopped.err;
    const auto rows = [&](const std::string& run) { return shell.must("graincrack-post history " + run); };
    EXPECT_GT(n_lines(rows("run.h5.checkpoint")), 1);
    EXPECT_LT(n_lines(rows("run.h5.checkpoint")), n_lines(rows("whole.h5")));
    shell.must("cp run.h5.checkpoint kept.h5\n" + test +
               "--quiet --restart run.h5.checkpoint --threads 2 --walltime 1h -o run.h5");
    EXPECT_EQ(rows("run.h5"), rows("whole.h5"));
    const Outcome other = shell.run(test + "--restart kept.h5 --damping 0.4 -o other.h5");
    EXPECT_EQ(other.exit_code, 3);
    EXPECT_NE(other.err.find("kept.h5: --damping was 0.8, not 0.4"), std::string::npos) << other.err;
    const Outcome piped = shell.run(test + "--walltime 1h -o - | cat >/dev/null; exit ${PIPESTATUS[0]}");
    EXPECT_NE(piped.err.find("--walltime: a run written to stdout"), std::string::npos) << piped.err;
}

TEST(Restart, ANewRunDoesNotRemoveACheckpointUnlessTold) {
    const Shell shell;
    shell.must("graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o specimen.h5");
    const std::string test = "graincrack-solve uniaxial specimen.h5 --material augig-granite --frames 2 --quiet -o run.h5 ";
    EXPECT_EQ(shell.run(test + "--walltime 50ms").exit_code, 143);
    const std::string before = content_of(shell.file("run.h5.checkpoint"));
    const Outcome refused = shell.run(test);
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    EXPECT_NE(refused.err.find("run.h5.checkpoint: is the checkpoint of a run that has not ended"), std::string::npos)
        << refused.err;
    EXPECT_EQ(content_of(shell.file("run.h5.checkpoint")), before);
    EXPECT_EQ(shell.names(), "run.h5.checkpoint\nspecimen.h5\n");
    // What a kill during the writing of a checkpoint left goes with the checkpoint.
    shell.must(": >run.h5.checkpoint.part\n: >run.h5.part\n: >run.h5.lock\ncp run.h5.checkpoint kept.h5\n" + test +
               "--restart run.h5.checkpoint\ngraincrack-post info --digest run.h5 >digest");
    EXPECT_EQ(shell.names(), "digest\nkept.h5\nrun.h5\nspecimen.h5\n");
    shell.must("mv kept.h5 run.h5.checkpoint\n" + test +
               "--discard-checkpoint\ngraincrack-post info --digest run.h5 | cmp - digest");
    EXPECT_EQ(shell.names(), "digest\nrun.h5\nspecimen.h5\n");
}

// Interrupted as a program that continued another run, or at the automatic rate.
TEST(Restart, AProgramGoesOnFromItsCheckpoint) {
    for (const std::string program : {"--program second.toml --restart first.h5 ", "--program auto.toml "}) {
        const Shell shell;
        lay_out_program(shell);
        shell.must(solve_program + "--program first.toml -o first.h5");
        shell.must("(until test -e whole.h5; do cp whole.h5.checkpoint kept.h5 2>/dev/null; sleep 0.02; done) & " +
                   solve_program + program + "--checkpoint-every 1ms -o whole.h5; wait");
        const auto rows = [&](const std::string& run) { return shell.must("graincrack-post history " + run); };
        EXPECT_GT(n_lines(rows("kept.h5")), 10);
        EXPECT_LT(n_lines(rows("kept.h5")), n_lines(rows("whole.h5")));
        EXPECT_NE(shell.run("test -e whole.h5.checkpoint").exit_code, 0);
        const std::string own = program.substr(0, program.find("toml") + 5);
        shell.must(solve_program + own + "--restart kept.h5 --threads 2 -o again.h5");
        EXPECT_EQ(rows("again.h5"), rows("whole.h5"));
        EXPECT_EQ(rows("again.h5 --stages"), rows("whole.h5 --stages"));
        EXPECT_EQ(rows("again.h5 --probe membrane"), rows("whole.h5 --probe membrane"));
        expect_same_arrays(H5Input(shell.file("again.h5")), H5Input(shell.file("whole.h5")), "/state");
        expect_same_arrays(H5Input(shell.file("again.h5")), H5Input(shell.file("whole.h5")), "/cracks");
        const Outcome outcome = shell.run(solve_program + "--program first.toml --restart kept.h5 -o other.h5");
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_NE(outcome.err.find("kept.h5: is the checkpoint of another program than first.toml"), std::string::npos)
            << outcome.err;
    }
}

TEST(Restart, TakesOtherContactValuesAndRefusesWhatDoesNotFit) {
    const Shell shell;
    lay_out_program(shell);
    shell.must(solve_program + "--program first.toml -o first.h5");
    shell.must(solve_program + "--program second.toml --restart first.h5 -o same.h5\n" + solve_program +
               "--program second.toml --restart first.h5 --contact-friction-angle 5deg --contact-cohesion 40MPa -o weak.h5");
    // The energy balance of each row is relative to the largest stored energy of both runs.
    const auto residual = [&](const std::string& run) {
        return std::atof(
            shell
                .must("graincrack-post history " + run +
                      " | awk -F'\\t' 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == \"energy_balance_error\") k = i; next } "
                      "{ r = $k < 0 ? -$k : $k; if (r > most) most = r } END { print (k > 0 ? most : 9) }'")
                .c_str());
    };
    const auto last_stress = [&](const std::string& run) {
        return std::atof(shell.must("graincrack-post history " + run + " | tail -1 | cut -f7").c_str());
    };
    EXPECT_GT(last_stress("weak.h5"), 0.95 * last_stress("same.h5"));  // compression is negative
    EXPECT_NE(last_stress("weak.h5"), last_stress("same.h5"));
    EXPECT_LT(residual("weak.h5"), 5e-3);
    const auto refused = [&](const std::string& options, const std::string& named) {
        const Outcome outcome = shell.run(solve_program + options + " -o run.h5");
        EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
    };
    shell.must(
        "cp first.h5 damaged.h5\n/usr/bin/python3 -c 'import h5py; f = h5py.File(\"damaged.h5\", \"r+\"); "
        "f[\"state/velocity\"][0, 0] += 1e-9'");
    refused("--program second.toml --restart damaged.h5", "digest: the file is damaged");
    refused("--program second.toml --restart first.h5 --plane stress", "plane condition");
    refused("--program second.toml --restart first.h5 --contact-law literal", "give --contact-law consistent");
    refused("--program second.toml --restart first.h5 --mass-scaling none", "--mass-scaling selective --mass-scaling-factor");
    refused("--program second.toml --restart specimen.h5", "specimen.h5");
    shell.must("graincrack-solve program specimen.h5 --material augig-granite --quiet --program first.toml -o stateless.h5");
    refused("--program second.toml --restart stateless.h5", "--save-state");
    shell.must("sed '/platens/d' second.toml | sed '/platen_speed/d' >free.toml");
    refused("--program free.toml --restart first.h5", "has platens that this program lacks");
    shell.must("graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --seed 2 --quiet -o specimen.h5");
    refused("--program second.toml --restart first.h5", "another specimen");
}

}  // namespace
}  // namespace graincrack::test
