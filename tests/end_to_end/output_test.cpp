// Output appears complete or not at all; data go to stdout, everything else to stderr.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Output, AStoppedRunLeavesACheckpointWithWhatThereIs) {
    for (const auto& [signal, number] : {std::pair{"TERM", 15}, {"USR2", 12}, {"XCPU", 24}}) {
        const Shell shell;
        shell.must(make_disc + "disc.h5");
        // The run would take hours; the signal is sent as soon as the unfinished file exists.
        const Outcome stopped = shell.run(
            "graincrack-solve brazilian disc.h5 --material augig-granite --rate 0.001mm/s --quiet -o run.h5 &\n"
            "for ((i = 0; i < 500; ++i)); do [[ -e run.h5.part ]] && break; sleep 0.02; done\n"
            "[[ -e run.h5.part && ! -e run.h5 ]] || echo 'no unfinished file seen'\nkill -" +
            std::string(signal) + " $!\nwait $!");
        EXPECT_EQ(stopped.exit_code, 128 + number) << stopped.err;
        EXPECT_EQ(stopped.out, "");
        EXPECT_EQ(n_lines(stopped.err), 1) << stopped.err;
        EXPECT_EQ(shell.names(), "disc.h5\nrun.h5.checkpoint\n");
        shell.must("graincrack-post history run.h5.checkpoint\ngraincrack-post info --check run.h5.checkpoint");
    }
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

TEST(Output, AFailedRunLeavesNothingButTheEarlierFile) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    const std::string unstable = "graincrack-solve brazilian disc.h5 --time-step-fraction 1.5 -o run.h5" + past_peak;
    const Outcome outcome = shell.run(unstable);
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
    EXPECT_EQ(shell.names(), "disc.h5\n");
    shell.must("graincrack-solve brazilian disc.h5 -o run.h5" + elastic);
    const std::string before = content_of(shell.file("run.h5"));
    EXPECT_EQ(shell.run(unstable).exit_code, 4);
    EXPECT_EQ(content_of(shell.file("run.h5")), before);
    EXPECT_EQ(shell.names(), "disc.h5\nrun.h5\n");
}

TEST(Output, DevicesAndPipesAreWrittenIntoAndNeverReplaced) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + elastic);
    const std::string solve = "graincrack-solve brazilian disc.h5" + elastic + "-o ";
    shell.must("mkfifo pipe page picture.svg\nln -s pipe link\ngraincrack-post info --digest - <pipe >digest &\n" + solve +
               "link\nwait $!\n[[ -p pipe && -L link ]]\n[[ $(cut -d' ' -f1 digest) == " +
               "$(graincrack-post info --digest run.h5 | cut -d' ' -f1) ]]");
    shell.must(
        "cat page >page.html & graincrack-post report run.h5 -o page; wait $!; [[ -p page ]]; grep -q '</html>' page.html");
    shell.must("cat picture.svg >copy & graincrack-post plot curve run.h5 -o picture.svg; wait $!; grep -q '</svg>' copy");
    shell.must(make_disc + "/dev/stdout | graincrack-post info -\ngraincrack-post report run.h5 -o - | grep -q '</html>'");
    EXPECT_EQ(shell.run(solve + "/dev/full").exit_code, 5);
    const Outcome walltime = shell.run(solve + "/dev/null --walltime 1h");
    EXPECT_EQ(walltime.exit_code, 2);
    // A device of the test's own, where it may make one.
    const Outcome outcome = shell.run("mknod null c 1 3 && mknod disk b 7 250 && echo null >null || exit 0\n" + solve + "null\n" +
                                      make_disc + "null\ngraincrack-post report run.h5 -o null\n[[ -c null ]] || exit 9\n" +
                                      solve + "disk\n[[ $? == 2 && -b disk ]]");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(shell.run("ls -A *.part *.lock *.checkpoint").out, "");
}

TEST(Output, ALinkToAFileStays) {
    const Shell shell;
    shell.must("mkdir store\nln -s store/disc.h5 disc.h5\n" + make_disc + "disc.h5\n[[ -L disc.h5 && -f store/disc.h5 ]]\n" +
               "graincrack-post info --check disc.h5\n[[ $(ls -A store) == disc.h5 ]]");
}

TEST(Output, AFileIsReplacedOnlyByItsOwnKind) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 --save-state -o run.h5" + elastic +
               "\ncp run.h5 page.html; cp run.h5 map.png; echo 'name = \"rock\"' >rock.toml; cp disc.h5 other.h5\n" +
               "graincrack-solve brazilian disc.h5 --print-program" + elastic + ">again.toml");
    const std::string before = shell.must("sha256sum *");
    const auto refused = [&](const std::string& command, const std::string& named) {
        const Outcome outcome = shell.run(command);
        EXPECT_EQ(outcome.exit_code, 2) << command << outcome.err;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
    };
    const std::string solve = "graincrack-solve brazilian disc.h5" + elastic;
    refused(solve + "-o disc.h5", "disc.h5: exists, and is no run");
    refused(solve + "-o rock.toml", "rock.toml: exists, and is no run");
    refused(make_disc + "run.h5", "run.h5: exists, and is no specimen");
    refused("graincrack-post report run.h5 -o run.h5", "--output run.h5: its name must end in .html");
    refused("graincrack-post report run.h5 -o page.html", "page.html: is a run");
    refused("graincrack-post plot curve run.h5 -o map.png", "map.png: is a run");
    refused(
        "graincrack-solve program disc.h5 --material augig-granite --program again.toml --damping 0.8 --restart run.h5 -o run.h5",
        "--output run.h5: is the run to start from");
    for (const char* ending : {"part", "lock", "checkpoint"}) {
        refused(solve + "-o run.h5." + ending, std::string("names in .") + ending);
        refused(make_disc + "run.h5." + ending, std::string("names in .") + ending);
    }
    EXPECT_EQ(shell.must("sha256sum *"), before);
    // A run replaces a run, and what is empty.
    shell.must(": >empty.h5\n" + solve + "-o run.h5\n" + solve + "-o empty.h5\n" + make_disc + "other.h5");
}

TEST(Output, AFullDiskIsOneLineAndLeavesNothing) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + past_peak);
    const std::string before = shell.names();
    for (const char* limit : {"ulimit -f 2", "ulimit -f 30", "ulimit -f 90", "trap '' XFSZ; ulimit -f 30"}) {
        for (const std::string& command :
             {"graincrack-solve brazilian disc.h5 -o out.h5" + past_peak,
              std::string("graincrack-mesh disc --diameter 80mm --grains 1000 --quiet -o out.h5"),
              std::string("graincrack-post plot cracks run.h5 --width 300mm --dpi 300 -o out.png")}) {
            const Outcome outcome = shell.run(std::string(limit) + "; " + command);
            EXPECT_EQ(outcome.exit_code, 5) << limit << "; " << command << "\n" << outcome.err;
            EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
            EXPECT_NE(outcome.err.find("out."), std::string::npos) << outcome.err;
            EXPECT_EQ(shell.names(), before);
        }
    }
}

TEST(Output, AHangupLeavesACheckpointUnlessItIsIgnored) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    // What starts the tests may have it ignored, as nohup has.
    const std::string hang_up =
        " graincrack-solve brazilian disc.h5 --material augig-granite --rate 0.001mm/s --quiet -o run.h5 &\n"
        "for ((i = 0; i < 500; ++i)); do [[ -e run.h5.part ]] && break; sleep 0.02; done\nkill -HUP $!\n";
    // Both the shell and the system send one when a terminal is closed.
    const Outcome stopped = shell.run("env --default-signal=HUP" + hang_up + "kill -HUP $!\nwait $!");
    EXPECT_EQ(stopped.exit_code, 128 + 1) << stopped.err;
    EXPECT_EQ(shell.names(), "disc.h5\nrun.h5.checkpoint\n");
    shell.must("rm run.h5.checkpoint\ntrap '' HUP\n" + hang_up + "sleep 0.3\nkill -0 $!\nkill -KILL $!\nwait $! || true");
}

TEST(Output, AKilledRunKeepsItsRowsWithItsFrames) {
    const Shell shell;
    shell.must("graincrack-mesh disc --diameter 80mm --grains 4000 --quiet -o disc.h5");
    // As soon as there is a frame there are rows; more of them once two seconds have passed. A copy is as a file whose writer is
    // dead.
    const std::string rows = shell.must(
        "graincrack-solve brazilian disc.h5 --material augig-granite --rate 5mm/s --quiet -o run.h5 &\n"
        "rows() { cp run.h5.part copy.h5 && graincrack-post history copy.h5 2>/dev/null | wc -l; }\n"
        "for ((i = 0; i < 500; ++i)); do n=$(rows) && ((n > 1)) && break; sleep 0.02; done\n"
        "sleep 4\nkill -KILL $!\nwait $! || true\necho \"$n\"\nrows");
    const int first = std::stoi(rows);
    EXPECT_GT(first, 1);
    EXPECT_LT(first, 400);
    EXPECT_GT(std::stoi(rows.substr(rows.find('\n'))), first);
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

TEST(Output, ARunThatCannotSayAnythingIsComplete) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    for (const char* nowhere : {"2>&-", "2>/dev/full"}) {
        shell.must(
            "graincrack-solve brazilian disc.h5 --material augig-granite --rate 400mm/s --max-strain 0.0003 --verbose -o "
            "run.h5 " +
            std::string(nowhere) + "\ngraincrack-post info --check run.h5\nrm run.h5");
    }
}

TEST(Output, ANameThatCannotBeWrittenIsRefusedBeforeTheRun) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + elastic +
               "\ncp run.h5 kept.h5\nchmod 444 kept.h5\n" + "ln -s nowhere linked.h5.lock\nchmod 640 run.h5");
    const std::string before = shell.names();
    for (const auto& [name, said] : {std::pair{std::string(241, 'a'), "its name has 241 bytes; 239 fit"},
                                     {std::string(300, 'a'), "its name has 300 bytes"},
                                     {std::string("kept.h5"), "kept.h5: is write-protected"},
                                     {std::string("linked.h5"), "linked.h5.lock: is a symbolic link"}}) {
        // It would take hours.
        const Outcome outcome =
            shell.run("graincrack-solve brazilian disc.h5 --material augig-granite --rate 0.001mm/s --quiet -o " + name);
        EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
        EXPECT_EQ(shell.names(), before);
    }
    shell.must("cmp run.h5 kept.h5");
    shell.must("graincrack-solve brazilian disc.h5 -o run.h5" + elastic + "\n[[ $(stat -c %a run.h5) == 640 ]]");
}

TEST(Output, PipesAreReadAsFilesAre) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + elastic +
               "\nmkfifo pipe\ncat disc.h5 >pipe &\ngraincrack-solve brazilian pipe --rate 400mm/s --max-strain 0.0003 --quiet "
               "-o again.h5 "
               "--material <(cat " GRAINCRACK_SOURCE
               "/share/materials/augig-granite.toml)\n"
               "[[ $(graincrack-post info --digest run.h5 | cut -d' ' -f1) == $(graincrack-post info --digest again.h5 | cut -d' "
               "' -f1) ]]");
}

/// As the tables count them: by the event of the law, tensile by the tractions.
TEST(Output, TheSolverSaysInThreeLinesWhatThePostprocessorCounts) {
    const Shell shell;
    shell.must("graincrack-mesh disc --diameter 20mm --grains 200 --quiet -o disc.h5\n" + make_disc + "few.h5");
    const std::string solve = "graincrack-solve brazilian disc.h5 --material augig-granite --max-strain 0.01 -o run.h5";
    const Outcome said = shell.run(solve);
    EXPECT_EQ(n_lines(said.err), 3) << said.err;
    const std::string counts = shell.must(
        "graincrack-post classes run.h5 | awk -F'\t' 'NR == 1 {for (i = 1; i <= NF; ++i) at[$i] = i} NR > 1 {t += "
        "$at[\"tensile_cracks_at_end\"]; s += $at[\"shear_cracks_at_end\"]} END {printf \"cracks: %d tensile, %d shear\", t + "
        "0.5, s + "
        "0.5}'");
    EXPECT_NE(said.err.find(counts + "\n"), std::string::npos) << counts << "\n" << said.err;
    EXPECT_NE(said.err.find("\nbrazilian: written to run.h5 after "), std::string::npos) << said.err;
    EXPECT_NE(shell.run(solve + " --verbose").err.find(" ns per grain and step"), std::string::npos);
    const Outcome few =
        shell.run("graincrack-solve brazilian few.h5 --material augig-granite --rate 400mm/s --max-strain 0.0003 -o run.h5");
    EXPECT_NE(few.err.find("brazilian: warning: 7.8 grains of the mean diameter across"), std::string::npos) << few.err;
}

TEST(Output, TheSecondToWriteAnOutputIsToldAndTheFirstIsNotHarmed) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 --frames 2 -o run.h5" + elastic);
    shell.must("mkdir maps");
    for (const auto& [lock, command] : {std::pair{"again.h5.lock", "graincrack-solve brazilian disc.h5 -o again.h5" + elastic},
                                        {"maps/cracks.lock", std::string("graincrack-post cracks run.h5 -o maps --quiet")},
                                        {"page.html.lock", std::string("graincrack-post report run.h5 -o page.html")}}) {
        const Outcome outcome = shell.run(std::string("flock ") + lock + " " + command);
        EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
        EXPECT_NE(outcome.err.find("is being written by another program"), std::string::npos) << outcome.err;
    }
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
    const Outcome undamped = shell.run(test + "undamped.h5 --damping none --rate-tolerance 0.0015");
    EXPECT_NE(undamped.err.find("far from equilibrium: the unbalanced ratio is"), std::string::npos) << undamped.err;
    EXPECT_NE(shell.run("graincrack-post strength undamped.h5").err.find("far from equilibrium"), std::string::npos);
    const Outcome slow = shell.run(test + "slow.h5 --rate auto");
    EXPECT_EQ(slow.err.find("equilibrium:"), std::string::npos) << slow.err;
}

TEST(Output, DirectTensionAtItsOwnRateIsNearEquilibrium) {
    const Shell shell;
    const std::string material = " --material augig-granite-calibrated ";
    shell.must("graincrack-mesh rectangle --width 30mm --height 60mm --quiet -o specimen.h5" + material);
    const Outcome test = shell.run("graincrack-solve tension specimen.h5 -o run.h5" + material);
    EXPECT_EQ(test.exit_code, 0);
    EXPECT_EQ(test.err.find("far from equilibrium"), std::string::npos) << test.err;
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
