// A run of several ranks is the run of one process: its file, its messages, its exit codes, its checkpoints.
#include <string>
#include <vector>

#include "tests/end_to_end/ranks.hpp"

namespace graincrack::test {
namespace {

class Ranks : public OnRanks {};

template <class Case>
std::string name_of_ranks_case(const testing::TestParamInfo<Case>& info) {
    return info.param.name;
}

/// A material with three phases, contacts of pairs, weaker veins and strengths that scatter; flaws; a program in four stages
/// with probes that passes the peak; the same as two programs of two stages.
void lay_out_ranks(const Shell& shell) {
    write_text(shell.file("phases.toml"), R"(
[phases]
quartz = { fraction = 0.4, relative_young_modulus = 1.4 }
feldspar = { fraction = 0.4 }
mica = { fraction = 0.2, relative_young_modulus = 0.4, density = "3000 kg/m3" }
[pairs]
quartz-mica = { tensile_strength = "12 MPa", cohesion = "40 MPa" }
heterophase = { friction_angle = 0.8 }
within = { tensile_strength = 1.25, cohesion = 1.25 }
[flaws.vein]
tensile_strength = "1 MPa"
cohesion = "2 MPa"
fracture_energy = "4 J/m2"
[strength]
modulus = 5
)");
    write_text(shell.file("flaws.tsv"), "x1_mm\ty1_mm\tx2_mm\ty2_mm\tclass\n-6\t-8\t4\t2\tbroken\n-2\t4\t7\t11\tvein\n");
    const std::string head = R"(
damping = 0.8
[platens]
[boundary.membrane]
on = ["left", "right"]
[probe.waist]
point = ["0 mm", "0 mm"]
[probe.core]
circle = ["0 mm", "0 mm", "6 mm"]
)";
    const std::string before_peak = R"(
[stage.confine]
membrane.pressure = { to = "2 MPa", over = "0.03 ms" }
platen_pressure = { to = "2 MPa", over = "0.03 ms" }
until.time = "0.04 ms"
[stage.press]
platen_speed = { auto = "together", tolerance = 0.1 }
until = { peak_drop = 0.1, time = "0.1 ms" }
)";
    const std::string after_peak = R"(
[stage.ease]
membrane.pressure = "keep"
platen_speed = { to = "-0.5 m/s", over = "0.01 ms" }
until.time = "0.03 ms"
[stage.crush]
membrane.pressure = "keep"
platen_speed = { to = "4 m/s", over = "0.02 ms" }
until.time = "0.15 ms"
)";
    const auto program = [&](const std::string& name, const std::string& stages, const std::string& tables) {
        write_text(shell.file(name + ".toml"), "name = \"" + name + "\"\nstages = [" + stages + "]\n" + head + tables);
    };
    program("cycle", R"("confine", "press", "ease", "crush")", before_peak + after_peak);
    program("first", R"("confine", "press")", before_peak);
    program("second", R"("ease", "crush")", after_peak);
    shell.must("cat " GRAINCRACK_SOURCE "/share/materials/augig-granite.toml phases.toml >minerals.toml");
}

const std::string small_rectangle = "rectangle --width 20mm --height 40mm ";

// --- the same digest ---------------------------------------------------------------------------------------------------

/// A test of the table. Four ranks have two chunks of nodes each at the least, and every thread has elements enough to be used.
struct RanksCase {
    const char* name;
    int ranks;
    int threads;
    const char* specimen;  ///< behind "graincrack-mesh"
    const char* test;
    const char* options;
    std::size_t least_cracks;    ///< contact points
    std::size_t least_contacts;  ///< active node–edge contacts at the end
};
void PrintTo(const RanksCase& c, std::ostream* stream) {  // NOLINT(readability-identifier-naming): as GoogleTest calls it
    *stream << c.ranks << " ranks of " << c.threads;
}

class EveryTestOnRanks : public OnRanks, public testing::WithParamInterface<RanksCase> {};

TEST_P(EveryTestOnRanks, HasTheDigestOfOneProcess) {
    const RanksCase& c = GetParam();
    const Shell shell;
    lay_out_ranks(shell);
    const std::string solve =
        std::string("graincrack-solve ") + c.test + " specimen.h5 " + c.options + " --quiet --frames 4 --save-state --threads ";
    shell.must(std::string("graincrack-mesh ") + c.specimen + " --quiet -o specimen.h5\n" + solve + "1 -o one.h5\n" +
               on_ranks(c.ranks) + solve + std::to_string(c.threads) + " -o ranks.h5");
    const Extent extent = extent_of(shell, "one.h5");
    EXPECT_GE(extent.cracks, c.least_cracks);
    EXPECT_GE(extent.active_node_edge_contacts, c.least_contacts);
    EXPECT_GT(extent.friction, 0);
    expect_same_run(shell, "ranks.h5", "one.h5");
    EXPECT_EQ(shell.run("ls -A *.part *.lock *.checkpoint").out, "");
}

// Every test has a row with mass scaling and one without, every law one on each number of ranks. In most of them grains have
// moved until others touch than were neighbours.
const std::vector<RanksCase> ranks_table{
    {"UniaxialFragments", 4, 1, "rectangle --width 20mm --height 40mm --grains 400", "uniaxial",
     "--material augig-granite --contact-law consistent --rate 1m/s --peak-drop none --max-strain 0.04", 800, 1000},
    {"UniaxialCrystalsWithFlaws", 2, 2,
     "rectangle --width 20mm --height 40mm --grains 130 --tessellation trigon --elements-per-crystal 8 --flaws flaws.tsv "
     "--material minerals.toml",
     "uniaxial",
     "--material minerals.toml --contact-law cohesive-frictional --mass-scaling none --rate 8m/s --peak-drop none "
     "--max-strain 0.02",
     1000, 500},
    {"TriaxialMinerals", 3, 1, "rectangle --width 20mm --height 40mm --grains 400 --material minerals.toml", "triaxial",
     "--material minerals.toml --contact-law cohesive-frictional --confining-pressure 3MPa --rate-tolerance 0.1 --rate-share 4 "
     "--peak-drop none --max-strain 0.03",
     600, 800},
    {"TriaxialPolygons", 1, 2, "rectangle --width 20mm --height 40mm --grains 80 --tessellation voronoi", "triaxial",
     "--material augig-granite --contact-law coulomb-slip --mass-scaling none --confining-pressure 3MPa --rate blocks "
     "--block-speed 4m/s --block-steps 500 --rate-tolerance 0.05 --peak-drop none --max-strain 0.03",
     100, 100},
    {"BrazilianSlit", 2, 1, "disc --diameter 20mm --grains 400 --slit 5mm --slit-angle 30deg", "brazilian",
     "--material augig-granite --contact-law coulomb-slip --rate 1m/s --peak-drop none --max-strain 0.06", 200, 500},
    {"BrazilianCrystals", 4, 1,
     "disc --diameter 20mm --grains 60 --tessellation trigon --elements-per-crystal 8 --material minerals.toml", "brazilian",
     "--material minerals.toml --contact-law cohesive-frictional --mass-scaling none --rate 6m/s --peak-drop none "
     "--max-strain 0.03",
     400, 150},
    {"TensionNotch", 1, 2, "rectangle --width 20mm --height 40mm --grains 600 --notch 6mm --material minerals.toml", "tension",
     "--material minerals.toml --contact-law cohesive-frictional --rate 1m/s --peak-drop none --max-strain 0.01", 200, 50},
    {"TensionOpenBoundaries", 3, 1,
     "rectangle --width 20mm --height 40mm --grains 50 --tessellation trigon --open-boundaries 20%", "tension",
     "--material augig-granite --contact-law consistent --mass-scaling none --rate 2m/s --peak-drop none --max-strain 0.01", 25,
     50},
    {"BendHalfDisc", 2, 2, "half-disc --diameter 40mm --slit 10mm --grains 1100 --material minerals.toml", "bend",
     "--material minerals.toml --contact-law consistent --rate 1m/s --peak-drop none --max-strain 0.015", 200, 500},
    {"BendBeam", 3, 1, "beam --length 60mm --height 12mm --grains 400", "bend",
     "--material augig-granite --contact-law coulomb-slip --mass-scaling none --rate 2m/s --peak-drop none --max-strain 0.03", 20,
     30},
    {"ProgramJoints", 1, 1, "rectangle --width 20mm --height 40mm --grains 400 --joint-set spacing=8mm,dip=60deg,persistence=0.6",
     "program", "--material augig-granite --contact-law consistent --program cycle.toml", 400, 1000},
    {"ProgramMinerals", 4, 1, "rectangle --width 20mm --height 40mm --grains 400 --material minerals.toml", "program",
     "--material minerals.toml --contact-law coulomb-slip --mass-scaling none --program cycle.toml", 200, 500},
};
INSTANTIATE_TEST_SUITE_P(Table, EveryTestOnRanks, testing::ValuesIn(ranks_table), name_of_ranks_case<RanksCase>);

// A disc of two chunks leaves two of four ranks without nodes.
TEST_F(Ranks, WithoutNodesChangeNothing) {
    const Shell shell;
    const std::string solve = "graincrack-solve brazilian disc.h5 --save-state" + past_peak + "-o ";
    shell.must(make_disc + "disc.h5\n" + solve + "one.h5\n" + on_ranks(4) + solve + "ranks.h5");
    EXPECT_GT(extent_of(shell, "one.h5").cracks, 20U);
    expect_same_run(shell, "ranks.h5", "one.h5");
}

TEST_F(Ranks, TakeASpecimenFromStdin) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o one.h5" + elastic + "\n" + on_ranks(2) +
               "graincrack-solve brazilian - -o ranks.h5" + elastic + "<disc.h5");
    expect_same_run(shell, "ranks.h5", "one.h5");
}

// The test is repeated with other options and on a refined specimen.
TEST_F(Ranks, MeasureTheSameSensitivity) {
    const Shell shell;
    const std::string solve =
        "graincrack-solve brazilian disc.h5 --sensitivity --rate 1m/s --max-strain 0.005 --quiet "
        "--material augig-granite -o ";
    const std::string one = shell.must(make_disc + "disc.h5\n" + solve + "one.h5");
    EXPECT_EQ(n_lines(one), 7) << one;
    EXPECT_EQ(shell.must(on_ranks(2) + solve + "ranks.h5"), one);
    expect_same_run(shell, "ranks.h5", "one.h5");
}

// --- messages ----------------------------------------------------------------------------------------------------------

TEST_F(Ranks, SayWhatOneProcessSays) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    const std::string solve = "graincrack-solve brazilian disc.h5 --material augig-granite --rate 1m/s --max-strain 0.01 ";
    const Outcome one = shell.run(solve + "-o one.h5");
    const Outcome ranks = shell.run(on_ranks(2) + solve + "-o ranks.h5");
    EXPECT_EQ(ranks.exit_code, 0) << ranks.err;
    EXPECT_EQ(ranks.out, one.out);
    for (const char* line : {"brazilian: ended by", "brazilian: energy balance error", "brazilian: warning"}) {
        EXPECT_NE(lines_of(line, one.err), "") << line << "\n" << one.err;
        EXPECT_EQ(lines_of(line, ranks.err), lines_of(line, one.err));
    }
    EXPECT_EQ(n_lines(lines_of("brazilian: 2 ranks: ", ranks.err)), 1) << ranks.err;
    EXPECT_EQ(n_lines(lines_of("brazilian: ", ranks.err)), n_lines(lines_of("brazilian: ", one.err)) + 1) << ranks.err;
    for (const std::string& print :
         {solve + "--print-config", solve + "--print-program", std::string("graincrack-solve --version"),
          std::string("graincrack-solve brazilian --help")}) {
        const std::string expected = shell.must(print);
        EXPECT_GT(n_lines(expected), 3) << print;
        EXPECT_EQ(shell.must(on_ranks(2) + print), expected) << print;
    }
    // The memory of a plan may be that of a rank.
    EXPECT_EQ(shell.must(on_ranks(2) + solve + "--dry-run | cut -f1"), shell.must(solve + "--dry-run | cut -f1"));
    EXPECT_EQ(shell.names(), "disc.h5\none.h5\nranks.h5\n");
}

struct BadInputOfRanks {
    const char* name;
    const char* options;
    int exit_code;
};
void PrintTo(const BadInputOfRanks& bad, std::ostream* stream) {  // NOLINT(readability-identifier-naming): as GoogleTest calls it
    *stream << "exit " << bad.exit_code;
}

class RefusedOnRanks : public OnRanks, public testing::WithParamInterface<BadInputOfRanks> {};

TEST_P(RefusedOnRanks, WithTheLineAndTheCodeOfOneProcess) {
    const BadInputOfRanks& bad = GetParam();
    const Shell shell;
    shell.must(make_disc + "disc.h5\nhead -c 20000 disc.h5 >truncated.h5");
    const std::string before = shell.names();
    const std::string solve = std::string("graincrack-solve brazilian ") + bad.options + past_peak;
    const Outcome one = shell.run(solve);
    EXPECT_EQ(one.exit_code, bad.exit_code) << one.err;
    EXPECT_EQ(n_lines(one.err), 1) << one.err;
    const Outcome ranks = shell.run(on_ranks(2) + solve);
    EXPECT_EQ(ranks.exit_code, bad.exit_code) << ranks.err;
    EXPECT_EQ(lines_of("graincrack-solve: ", ranks.err), one.err);
    EXPECT_EQ(ranks.out, "");
    EXPECT_EQ(shell.names(), before);
}

const std::vector<BadInputOfRanks> bad_inputs_of_ranks{
    {"UnknownOption", "disc.h5 -o run.h5 --bogus", 2},
    {"OutputIsASpecimen", "disc.h5 -o disc.h5", 2},
    {"MissingSpecimen", "none.h5 -o run.h5", 3},
    {"DamagedSpecimen", "truncated.h5 -o run.h5", 3},
    {"NoCheckpoint", "disc.h5 -o run.h5 --restart disc.h5", 3},
    {"Unstable", "disc.h5 -o run.h5 --time-step-fraction 1.5", 4},
    {"MissingFolder", "disc.h5 -o nowhere/run.h5", 5},
    {"FullDevice", "disc.h5 -o /dev/full", 5},
};
INSTANTIATE_TEST_SUITE_P(Table, RefusedOnRanks, testing::ValuesIn(bad_inputs_of_ranks), name_of_ranks_case<BadInputOfRanks>);

// The other ranks are in the middle of the test when the first one cannot write.
TEST_F(Ranks, EndWhereADiskIsFull) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\nmkdir small");
    if (shell.run("mount -t tmpfs -o size=128k graincrack-test small && umount small").exit_code != 0) {
        GTEST_SKIP() << "a small disk takes root rights";
    }
    const auto fill = [&](const std::string& prefix) {
        return shell.run("mount -t tmpfs -o size=128k graincrack-test small || exit 1\n" + prefix +
                         "timeout -s KILL 60 graincrack-solve brazilian disc.h5 -o small/run.h5" + past_peak +
                         "\ncode=$?\nls -A small\numount small\nexit $code");
    };
    const Outcome one = fill("");
    EXPECT_EQ(one.exit_code, 5) << one.err;
    const Outcome ranks = fill(on_ranks(2));
    EXPECT_EQ(ranks.exit_code, 5) << ranks.err;
    EXPECT_EQ(lines_of("graincrack-solve: ", ranks.err), one.err);
    EXPECT_EQ(ranks.out, "");
}

// --- checkpoints and restarts ------------------------------------------------------------------------------------------

/// A test of some seconds that spends most of them behind its peak.
const std::string long_test =
    "graincrack-solve uniaxial specimen.h5 --material augig-granite --rate 1m/s --peak-drop none --max-strain 0.05 --frames 2 "
    "--save-state ";
const std::string make_long_specimen = "graincrack-mesh " + small_rectangle + "--grains 600 --quiet -o specimen.h5\n";

std::ptrdiff_t n_rows(const Shell& shell, const std::string& run) {
    return n_lines(shell.must("graincrack-post history " + run));
}

TEST_F(Ranks, AStoppedRunResumesOnAnyNumberOfThem) {
    const Shell shell;
    shell.must(make_long_specimen + long_test + "--quiet -o whole.h5");
    std::ptrdiff_t rows = 1;
    std::string resume;
    for (const int n : {3, 2}) {
        const Outcome stopped = shell.run(on_ranks(n) + long_test + "--walltime 150ms -o run.h5 " + resume);
        EXPECT_EQ(stopped.exit_code, 143) << stopped.err;
        EXPECT_EQ(n_lines(lines_of("graincrack-solve: ", stopped.err)), 1) << stopped.err;
        EXPECT_NE(stopped.err.find("--restart run.h5.checkpoint resumes it"), std::string::npos) << stopped.err;
        EXPECT_EQ(shell.names(), "run.h5.checkpoint\nspecimen.h5\nwhole.h5\n");
        EXPECT_GT(n_rows(shell, "run.h5.checkpoint"), rows);
        rows = n_rows(shell, "run.h5.checkpoint");
        resume = "--restart run.h5.checkpoint";
    }
    EXPECT_LT(rows, n_rows(shell, "whole.h5"));
    shell.must(long_test + "--quiet -o run.h5 " + resume);
    expect_same_run(shell, "run.h5", "whole.h5");
    EXPECT_EQ(shell.names(), "run.h5\nspecimen.h5\nwhole.h5\n");
}

TEST_F(Ranks, ACheckpointOfOneProcessResumesOnThem) {
    const Shell shell;
    shell.must(make_long_specimen + long_test + "--quiet -o whole.h5");
    EXPECT_EQ(shell.run(long_test + "--walltime 150ms -o run.h5").exit_code, 143);
    shell.must(on_ranks(2) + long_test + "--quiet --threads 2 --restart run.h5.checkpoint -o run.h5");
    expect_same_run(shell, "run.h5", "whole.h5");
}

TEST_F(Ranks, AProgramResumesFromTheirCheckpoint) {
    const Shell shell;
    lay_out_ranks(shell);
    shell.must("graincrack-mesh " + small_rectangle + "--grains 400 --material minerals.toml --quiet -o specimen.h5");
    const std::string solve =
        "graincrack-solve program specimen.h5 --material minerals.toml --program cycle.toml --save-state --frames 3 --quiet ";
    shell.must(solve +
               "-o whole.h5\n(until test -e ranks.h5; do cp run.h5.checkpoint kept.h5 2>/dev/null; sleep 0.02; done) &\n" +
               on_ranks(3) + solve + "--checkpoint-every 1ms -o run.h5 && mv run.h5 ranks.h5 || touch ranks.h5; wait");
    expect_same_run(shell, "ranks.h5", "whole.h5");
    EXPECT_GT(n_rows(shell, "kept.h5"), 2);
    EXPECT_LT(n_rows(shell, "kept.h5"), n_rows(shell, "whole.h5"));
    shell.must(on_ranks(2) + solve + "--restart kept.h5 -o two.h5\n" + solve + "--restart kept.h5 -o one.h5");
    expect_same_run(shell, "two.h5", "whole.h5");
    expect_same_run(shell, "one.h5", "whole.h5");
}

TEST_F(Ranks, AProgramStartsFromTheirState) {
    const Shell shell;
    lay_out_ranks(shell);
    shell.must("graincrack-mesh " + small_rectangle + "--grains 400 --material minerals.toml --quiet -o specimen.h5");
    const std::string solve = "graincrack-solve program specimen.h5 --material minerals.toml --save-state --quiet --program ";
    const std::string second = solve + "second.toml --restart ";
    shell.must(solve + "first.toml -o first.h5\n" + second + "first.h5 -o second.h5\n" + on_ranks(3) + solve +
               "first.toml -o first-3.h5\n" + on_ranks(2) + second + "first-3.h5 -o second-2.h5\n" + second +
               "first-3.h5 -o second-1.h5");
    const Extent extent = extent_of(shell, "second.h5");
    EXPECT_GT(extent.cracks, 200U);
    EXPECT_GT(extent.active_node_edge_contacts, 500U);
    expect_same_run(shell, "first-3.h5", "first.h5");
    expect_same_run(shell, "second-2.h5", "second.h5");
    expect_same_run(shell, "second-1.h5", "second.h5");
}

// --- signals and deaths ------------------------------------------------------------------------------------------------

/// Lines of bash that start a command on ranks in the background. The job is mpirun; pid.N has the process of rank N.
std::string start_on_ranks(int n, const std::string& command) {
    return on_ranks(n) + "bash -c 'echo $$ >pid.$OMPI_COMM_WORLD_RANK; exec \"$@\"' bash " + command + " &\njob=$!\n";
}
/// Waits until a file is there, for 20 s at most.
std::string wait_for_file(const std::string& name) {
    return "for ((i = 0; i < 1000; ++i)); do [[ -e " + name + " ]] && break; sleep 0.02; done\n";
}
/// Ends with the exit code of the job. One that has not ended within 20 s is killed, and its output says so.
const std::string end_of_job =
    "for ((i = 0; i < 1000; ++i)); do kill -0 $job 2>/dev/null || break; sleep 0.02; done\n"
    "if kill -0 $job 2>/dev/null; then echo 'does not end'; kill -KILL $job $(cat pid.*); fi\n"
    "rm -f pid.*\nwait $job\n";

class ADeadRank : public OnRanks, public testing::WithParamInterface<int> {};

TEST_P(ADeadRank, EndsTheRunWhoseLastCheckpointResumes) {
    const int rank = GetParam();
    const Shell shell;
    shell.must(make_long_specimen + long_test + "--quiet -o whole.h5");
    const Outcome killed =
        shell.run(start_on_ranks(3, long_test + "--quiet --checkpoint-every 100ms -o run.h5") +
                  wait_for_file("run.h5.checkpoint") + "kill -KILL $(cat pid." + std::to_string(rank) + ")\n" + end_of_job);
    EXPECT_NE(killed.exit_code, 0);
    EXPECT_EQ(killed.out, "");
    const std::string said = lines_of("graincrack-solve: ", killed.err);
    if (rank == 0) {  // which alone speaks
        EXPECT_LE(n_lines(said), 1) << killed.err;
    } else {
        EXPECT_EQ(n_lines(said), 1) << killed.err;
        EXPECT_NE(said.find("rank"), std::string::npos) << killed.err;
    }
    EXPECT_NE(shell.run("test -e run.h5").exit_code, 0);
    shell.must("graincrack-post info --check run.h5.checkpoint\n" + long_test + "--quiet --restart run.h5.checkpoint -o run.h5");
    expect_same_run(shell, "run.h5", "whole.h5");
    EXPECT_EQ(shell.names(), "run.h5\nspecimen.h5\nwhole.h5\n");
}
INSTANTIATE_TEST_SUITE_P(OfThreeRanks, ADeadRank, testing::Values(0, 1, 2));

// Fragments are where the specimen broke: at a checkpoint the ranks share the work anew.
TEST_F(Ranks, ShareTheWorkAnewAtCheckpoints) {
    const Shell shell;
    const std::string test =
        "graincrack-solve uniaxial specimen.h5 --material augig-granite --rate-tolerance 0.1 --max-strain 0.01 --peak-drop "
        "0.95 ";
    shell.must("graincrack-mesh rectangle --width 80mm --height 160mm --grains 1122 --material augig-granite -o specimen.h5\n" +
               test + "--quiet -o whole.h5");
    const Outcome ranks = shell.run(on_ranks(2) + test + "--checkpoint-every 300ms --rebalance 1.001 -o run.h5");
    EXPECT_EQ(ranks.exit_code, 0) << ranks.err;
    EXPECT_GE(n_lines(lines_of("uniaxial: the busiest rank had", ranks.err)), 1) << ranks.err;
    expect_same_run(shell, "run.h5", "whole.h5");
}

TEST_F(Ranks, AreStoppedBySIGTERMWithACheckpoint) {
    const Shell shell;
    shell.must(make_long_specimen + long_test + "--quiet -o whole.h5");
    const Outcome stopped = shell.run(start_on_ranks(2, long_test + "--quiet -o run.h5") + wait_for_file("run.h5.part") +
                                      "sleep 0.3\nkill -TERM $(cat pid.*)\n" + end_of_job);
    EXPECT_EQ(stopped.exit_code, 128 + 15) << stopped.err;
    EXPECT_EQ(stopped.out, "");
    EXPECT_EQ(n_lines(lines_of("graincrack-solve: ", stopped.err)), 1) << stopped.err;
    EXPECT_EQ(shell.names(), "run.h5.checkpoint\nspecimen.h5\nwhole.h5\n");
    shell.must(on_ranks(3) + long_test + "--quiet --restart run.h5.checkpoint -o run.h5");
    expect_same_run(shell, "run.h5", "whole.h5");
}

// It passes the signal on after a second, and kills the ranks as soon as the first of them has ended or after another second. Its
// exit code is its own.
TEST_F(Ranks, LeaveACheckpointWhenMpirunIsStopped) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    const Outcome stopped = shell.run(
        start_on_ranks(2, "graincrack-solve brazilian disc.h5 --material augig-granite --rate 0.001mm/s --quiet -o run.h5") +
        wait_for_file("run.h5.part") + "sleep 0.3\nkill -TERM $job\n" + end_of_job);
    EXPECT_NE(stopped.exit_code, 0);
    EXPECT_EQ(stopped.out, "");
    EXPECT_EQ(n_lines(lines_of("graincrack-solve: ", stopped.err)), 1) << stopped.err;
    EXPECT_EQ(shell.names(), "disc.h5\nrun.h5.checkpoint\n");
    shell.must("graincrack-post info --check run.h5.checkpoint");
}

// mpirun passes it on to all ranks.
TEST_F(Ranks, MakeACheckpointOnSIGUSR1AndTheRunGoesOn) {
    const Shell shell;
    shell.must(make_long_specimen + long_test + "--quiet -o whole.h5");
    const Outcome asked = shell.run(start_on_ranks(2, long_test + "--quiet -o run.h5") + wait_for_file("run.h5.part") +
                                    "sleep 0.3\nkill -USR1 $job\n" + wait_for_file("run.h5.checkpoint") +
                                    "ln run.h5.checkpoint kept.h5\n" + end_of_job);
    EXPECT_EQ(asked.exit_code, 0) << asked.err;
    EXPECT_EQ(asked.out, "");
    expect_same_run(shell, "run.h5", "whole.h5");
    shell.must(long_test + "--quiet --restart kept.h5 -o again.h5");
    expect_same_run(shell, "again.h5", "whole.h5");
}

}  // namespace
}  // namespace graincrack::test
