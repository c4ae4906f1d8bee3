// Output appears complete or not at all; data go to stdout, everything else to stderr.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Output, AStoppedRunLeavesNothing) {
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
    EXPECT_EQ(shell.names(), "disc.h5\n");
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
         {make_disc + "-", "graincrack-solve brazilian disc.h5 -o -" + elastic, std::string("graincrack-post strength run.h5"),
          std::string("graincrack-post history run.h5")}) {
        const Outcome outcome = shell.run(command + " >/dev/full");
        EXPECT_EQ(outcome.exit_code, 5) << command;
        EXPECT_EQ(n_lines(outcome.err), 1) << command << "\n" << outcome.err;
    }
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
