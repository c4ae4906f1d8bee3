// A run of several ranks is the run of one process: its file, its messages, its exit codes, its checkpoints.
#include <string>
#include <utility>

#include "tests/end_to_end/ranks.hpp"

namespace graincrack::test {
namespace {

class Ranks : public OnRanks {};

/// A test of some seconds that spends most of them behind its peak, in which grains come to touch others than their neighbours.
const std::string long_test =
    "graincrack-solve uniaxial specimen.h5 --material augig-granite --rate 1m/s --peak-drop none --max-strain 0.05 --frames 2 "
    "--save-state ";
const std::string make_long_specimen =
    "graincrack-mesh rectangle --width 20mm --height 40mm --grains 600 --quiet -o specimen.h5\n";

// --- the same digest ---------------------------------------------------------------------------------------------------

TEST_F(Ranks, WithThreadsHaveTheDigestOfOneProcess) {
    const Shell shell;
    shell.must(make_long_specimen + long_test + "--quiet -o one.h5\n" + on_ranks(2) + long_test +
               "--quiet --threads 2 -o ranks.h5");
    const Extent extent = extent_of(shell, "one.h5");
    EXPECT_GE(extent.cracks, 800U);
    EXPECT_GE(extent.active_node_edge_contacts, 1000U);
    EXPECT_GT(extent.friction, 0);
    expect_same_run(shell, "ranks.h5", "one.h5");
    EXPECT_EQ(shell.run("ls -A *.part *.lock *.checkpoint").out, "");
}

TEST_F(Ranks, TakeASpecimenFromStdin) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o one.h5" + elastic + "\n" + on_ranks(2) +
               "graincrack-solve brazilian - -o ranks.h5" + elastic + "<disc.h5");
    expect_same_run(shell, "ranks.h5", "one.h5");
}

// --- messages ----------------------------------------------------------------------------------------------------------

TEST_F(Ranks, SayWhatOneProcessSays) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    const std::string solve = "graincrack-solve brazilian disc.h5 --material augig-granite --rate 1m/s --max-strain 0.01 ";
    const Outcome one = shell.run(solve + "--verbose -o one.h5");
    const Outcome ranks = shell.run(on_ranks(2) + solve + "--verbose -o ranks.h5");
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

/// A line and a code as of one process, whether all ranks find the error, the first one alone, or those whose nodes move too
/// fast.
TEST_F(Ranks, RefuseWithTheLineAndTheCodeOfOneProcess) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    const std::string before = shell.names();
    for (const auto& [options, exit_code] :
         {std::pair("disc.h5 -o run.h5 --bogus", 2), std::pair("none.h5 -o run.h5", 3),
          std::pair("disc.h5 -o run.h5 --time-step-fraction 1.5", 4), std::pair("disc.h5 -o nowhere/run.h5", 5)}) {
        SCOPED_TRACE(options);
        const std::string solve = std::string("graincrack-solve brazilian ") + options + past_peak;
        const Outcome one = shell.run(solve);
        EXPECT_EQ(one.exit_code, exit_code) << one.err;
        EXPECT_EQ(n_lines(one.err), 1) << one.err;
        const Outcome ranks = shell.run(on_ranks(2) + solve);
        EXPECT_EQ(ranks.exit_code, exit_code) << ranks.err;
        EXPECT_EQ(lines_of("graincrack-solve: ", ranks.err), one.err);
        EXPECT_EQ(ranks.out, "");
        EXPECT_EQ(shell.names(), before);
    }
}

TEST_F(Ranks, WithDifferentOptionsOrFilesRunNothing) {
    const Shell shell;
    shell.must(make_disc +
               "disc.h5\nmkdir own other\ngraincrack-mesh disc --diameter 20mm --grains 61 --quiet -o other/disc.h5\n"
               "sed 's/^density.*/density = 2000/' " GRAINCRACK_SOURCE
               "/share/materials/augig-granite.toml >other/augig-granite.toml\ncp disc.h5 own");
    const std::string before = shell.names();
    const auto solve = [](const std::string& rest, const std::string& environment = "") {
        return environment + "bash -c 'cd ${folder:-.}; exec \"$@\"' bash graincrack-solve brazilian disc.h5 -o run.h5" +
               past_peak + rest;
    };
    for (const auto& [other, line] :
         {std::pair(solve("--damping 0.7"), "--damping: 0.8 on rank 0, 0.7 on rank 2"),
          std::pair(solve("", "env GRAINCRACK_MATERIALS=other "),
                    "material: density: 2650 kg/m3 on rank 0, 2000 kg/m3 on rank 2"),
          std::pair(solve("", "env folder=other "), "the specimen: content "), std::pair(solve("--bogus"), "--bogus")}) {
        SCOPED_TRACE(line);
        const Outcome ranks = shell.run(on_ranks(2, 30) + solve("") + ": -n 1 " + other);
        EXPECT_EQ(ranks.exit_code, 2) << ranks.err;
        EXPECT_EQ(n_lines(lines_of("graincrack-solve: ", ranks.err)), 1) << ranks.err;
        EXPECT_NE(ranks.err.find(line), std::string::npos) << ranks.err;
        EXPECT_EQ(ranks.err.find("MPI_"), std::string::npos) << ranks.err;
        EXPECT_EQ(shell.names(), before);
    }
}

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

// mpirun ends the job whose rank has died.
TEST_F(Ranks, ADeadRankEndsTheRunWhoseLastCheckpointResumes) {
    const Shell shell;
    shell.must(make_long_specimen + long_test + "--quiet -o whole.h5");
    const Outcome killed = shell.run(start_on_ranks(3, long_test + "--quiet --checkpoint-every 100ms -o run.h5") +
                                     wait_for_file("run.h5.checkpoint") + "kill -KILL $(cat pid.1)\n" + end_of_job);
    EXPECT_NE(killed.exit_code, 0);
    EXPECT_EQ(killed.out, "");
    EXPECT_NE(shell.run("test -e run.h5").exit_code, 0);
    shell.must("graincrack-post info --check run.h5.checkpoint\n" + long_test + "--quiet --restart run.h5.checkpoint -o run.h5");
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

}  // namespace
}  // namespace graincrack::test
