// Output appears complete or not at all; data go to stdout, everything else to stderr.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Output, AStoppedRunLeavesACheckpointWithWhatThereIs) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    // The run would take hours; the signal is sent as soon as the unfinished file exists.
    const Outcome stopped = shell.run(
        "graincrack-solve brazilian disc.h5 --material augig-granite --rate 0.001mm/s --quiet -o run.h5 &\n"
        "for ((i = 0; i < 500; ++i)); do [[ -e run.h5.part ]] && break; sleep 0.02; done\n"
        "[[ -e run.h5.part && ! -e run.h5 ]] || echo 'no unfinished file seen'\nkill -TERM $!\nwait $!");
    EXPECT_EQ(stopped.exit_code, 128 + 15) << stopped.err;
    EXPECT_EQ(stopped.out, "");
    EXPECT_EQ(n_lines(stopped.err), 1) << stopped.err;
    EXPECT_EQ(shell.names(), "disc.h5\nrun.h5.checkpoint\n");
    shell.must("graincrack-post history run.h5.checkpoint\ngraincrack-post info --check run.h5.checkpoint");
}

TEST(Output, ASignalOfASchedulerMakesACheckpointAndTheRunGoesOn) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    shell.must(
        "graincrack-solve brazilian disc.h5 --material augig-granite --rate 0.001mm/s --quiet -o run.h5 &\n"
        "for ((i = 0; i < 500; ++i)); do [[ -e run.h5.part ]] && break; sleep 0.02; done\nsleep 0.3\nkill -USR1 $!\n"
        "for ((i = 0; i < 500; ++i)); do [[ -e run.h5.checkpoint ]] && break; sleep 0.02; done\n"
        "graincrack-post info --check run.h5.checkpoint\nkill -0 $!\nkill -KILL $!\nwait $! || true");
}

TEST(Output, AFailedRunLeavesNothing) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    const Outcome unstable = shell.run("graincrack-solve brazilian disc.h5 --time-step-fraction 1.5 -o run.h5" + past_peak);
    EXPECT_EQ(unstable.exit_code, 4) << unstable.err;
    EXPECT_EQ(n_lines(unstable.err), 1) << unstable.err;
    EXPECT_EQ(shell.names(), "disc.h5\n");
}

TEST(Output, AnEarlierFileSurvivesAFailure) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\necho precious >run.h5");
    EXPECT_EQ(shell.run("graincrack-solve brazilian disc.h5 --time-step-fraction 1.5 -o run.h5" + past_peak).exit_code, 4);
    EXPECT_EQ(content_of(shell.file("run.h5")), "precious\n");
    EXPECT_EQ(shell.names(), "disc.h5\nrun.h5\n");
}

TEST(Output, AFullDeviceIsOneLine) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + elastic);
    for (const std::string& command :
         {std::string("graincrack-mesh --help"), std::string("graincrack-solve --version"), std::string("graincrack-post --help"),
          std::string("graincrack-solve brazilian disc.h5 --dry-run") + elastic,
          std::string("graincrack-solve brazilian disc.h5 --print-config") + elastic, make_disc + "-",
          "graincrack-solve brazilian disc.h5 -o -" + elastic, std::string("graincrack-post strength run.h5"),
          std::string("graincrack-post history run.h5")}) {
        const Outcome outcome = shell.run(command + " >/dev/full");
        EXPECT_EQ(outcome.exit_code, 5) << command;
        EXPECT_EQ(n_lines(outcome.err), 1) << command << "\n" << outcome.err;
    }
}

TEST(Output, ClosedStreamsEndWithTheCodeOfOutputAndTakeNoFile) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    EXPECT_EQ(shell.run("graincrack-post info disc.h5 >&- 2>&-").exit_code, 5);
    shell.must("graincrack-solve brazilian disc.h5 -o run.h5" + elastic + ">&- 2>&- <&-\ngraincrack-post info --check run.h5");
}

TEST(Output, AFileCannotCommandTheTerminal) {
    const Shell shell;
    shell.must(make_disc +
               "disc.h5\n/usr/bin/python3 -c 'import h5py, numpy; f = h5py.File(\"disc.h5\", \"r+\"); "
               "f[\"specimen\"].attrs[\"shape\"] = numpy.bytes_(b\"\\x1b[2Jdisc\\x07\")'");
    const Outcome info = shell.run("graincrack-post info disc.h5");
    EXPECT_EQ(info.out.find('\x1b'), std::string::npos);
    EXPECT_NE(info.out.find("\\x1b[2Jdisc\\x07"), std::string::npos) << info.out;
    const Outcome missing = shell.run("graincrack-post info $'\\x1b[2J.h5'");
    EXPECT_EQ(missing.exit_code, 3);
    EXPECT_EQ(missing.err.find('\x1b'), std::string::npos);
}

TEST(Output, TheSecondToWriteAnOutputIsToldAndTheFirstIsNotHarmed) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 --frames 2 -o run.h5" + elastic);
    const Outcome solve = shell.run("flock again.h5.lock graincrack-solve brazilian disc.h5 -o again.h5" + elastic);
    EXPECT_EQ(solve.exit_code, 5) << solve.err;
    EXPECT_NE(solve.err.find("again.h5: is being written by another program"), std::string::npos) << solve.err;
    const Outcome cracks = shell.run("mkdir maps; flock maps/cracks.lock graincrack-post cracks run.h5 -o maps --quiet");
    EXPECT_EQ(cracks.exit_code, 5) << cracks.err;
    EXPECT_NE(cracks.err.find("is being written by another program"), std::string::npos) << cracks.err;
    // What a dead program leaves of its lock is no obstacle.
    shell.must("graincrack-solve brazilian disc.h5 -o again.h5" + elastic + "\ngraincrack-post cracks run.h5 -o maps --quiet\n" +
               "[[ ! -e again.h5.lock && ! -e maps/cracks.lock ]]");
}

TEST(Output, AnExportThatIsStoppedHasNoListsOfFiles) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 --frames 20 -o run.h5" + past_peak +
               "\ngraincrack-post cracks run.h5 -o maps --quiet\n[[ -e maps/grains.pvd && -e maps/cracks.pvd ]]");
    // Stopped before its last file: summary.tsv cannot be replaced by a folder's place.
    shell.must("rm maps/fragments.tsv && mkdir maps/fragments.tsv");
    EXPECT_EQ(shell.run("graincrack-post cracks run.h5 -o maps --quiet").exit_code, 5);
    shell.must("[[ ! -e maps/grains.pvd && ! -e maps/cracks.pvd ]]");
}

TEST(Output, ATestFarFromEquilibriumIsCalledSo) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    const std::string test = "graincrack-solve brazilian disc.h5 --material augig-granite --max-strain 0.004 -o ";
    const Outcome fast = shell.run(test + "fast.h5 --rate 1m/s");
    EXPECT_NE(fast.err.find("far from equilibrium: at the peak the load rises by"), std::string::npos) << fast.err;
    const Outcome strength = shell.run("graincrack-post strength fast.h5");
    EXPECT_EQ(strength.exit_code, 0);
    EXPECT_NE(strength.err.find("fast.h5: warning: the test is far from equilibrium"), std::string::npos) << strength.err;
    shell.must("graincrack-post report fast.h5 -o page.html");
    EXPECT_NE(content_of(shell.file("page.html")).find("far from equilibrium"), std::string::npos);
    const Outcome undamped = shell.run(test + "undamped.h5 --damping none --rate auto");
    EXPECT_NE(undamped.err.find("far from equilibrium: the unbalanced ratio is"), std::string::npos) << undamped.err;
    EXPECT_NE(shell.run("graincrack-post strength undamped.h5").err.find("far from equilibrium"), std::string::npos);
    const Outcome slow = shell.run(test + "slow.h5 --rate auto");
    EXPECT_EQ(slow.err.find("equilibrium:"), std::string::npos) << slow.err;
    // Blocks of a high speed do work before anything is stored.
    shell.must(
        "graincrack-mesh rectangle --width 40mm --height 80mm --grains 300 --seed 4 --quiet -o rectangle.h5\n"
        "graincrack-solve uniaxial rectangle.h5 --material augig-granite --rate blocks --block-steps 10 "
        "--block-speed 100m/s --max-strain 0.0005 --quiet --frames 0 -o blocks.h5");
}

TEST(Output, AReaderThatHasEnoughEndsTheToolQuietly) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + past_peak);
    const Outcome outcome = shell.run(
        "graincrack-post history run.h5 run.h5 | true; set +o pipefail\n"
        "graincrack-post history run.h5 | head -n 1");
    const Outcome pipe = shell.run(make_disc + "- | head -c 100 >/dev/null; echo ${PIPESTATUS[0]}");
    EXPECT_EQ(n_lines(outcome.out), 1);
    EXPECT_EQ(pipe.err, "");
}

TEST(Output, ProgressAndReportsStayOffStdout) {
    const Shell shell;
    const Outcome mesh = shell.run("graincrack-mesh disc --diameter 20mm --grains 60 -o disc.h5");
    EXPECT_EQ(mesh.out, "");
    EXPECT_NE(mesh.err.find("60 grains"), std::string::npos) << mesh.err;
    const Outcome solve =
        shell.run("graincrack-solve brazilian disc.h5 --material augig-granite --rate 400mm/s --max-strain 0.0003 -o run.h5");
    EXPECT_EQ(solve.out, "");
    EXPECT_NE(solve.err.find("brazilian"), std::string::npos) << solve.err;
    const Outcome quiet = shell.run("graincrack-solve brazilian disc.h5 -o run.h5" + elastic);
    EXPECT_EQ(quiet.out + quiet.err, "");
}

}  // namespace
}  // namespace graincrack::test
