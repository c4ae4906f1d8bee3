// Sources of options: flags and configuration file; --print-config and --dry-run.
#include <cmath>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Configuration, PrintedOneLoadsAgain) {
    const Shell shell;
    for (const std::string command : {
             "graincrack-mesh disc --diameter 20mm --grains 60 --seed 7 --pole vertex -o disc.h5",
             "graincrack-solve triaxial disc.h5 --material augig-granite --confining-pressure 4MPa --damping none -o run.h5",
             "graincrack-post strength --format jsonl",
             "graincrack-post plot cracks --frame 3 --magnify 50 -o cracks.png",
             "graincrack-post plot curve --x-limits 0,0.3 --label run.h5=dry -o curve.png",
             "graincrack-post plot curve --title words -o curve.png",
         }) {
        const std::string subcommand = command.substr(0, command.find(" -"));
        const std::string words = subcommand.substr(0, subcommand.find(" disc.h5"));
        const std::string printed = shell.must(command + " --print-config | tee config.toml");
        EXPECT_GT(n_lines(printed), 2) << command;
        EXPECT_EQ(shell.must(words + " --config config.toml --print-config"), printed) << command;
    }
    EXPECT_EQ(shell.names(), "config.toml\n");
}

TEST(DryRun, TellsCountsAndLeavesNothing) {
    const Shell shell;
    shell.must(make_disc + "disc.h5");
    const std::string solve = shell.must("graincrack-solve brazilian disc.h5 --material augig-granite --dry-run -o run.h5");
    for (const char* key : {"grains\t60\n", "threads\t1\nbalance_of_nodes\t1.000\nbalance_of_forces\t1.000\n", "time_step_s\t",
                            "max_steps\t", "memory_MB\t", "file_size", "estimated_time"}) {
        EXPECT_NE(solve.find(key), std::string::npos) << key << " in\n" << solve;
    }
    EXPECT_EQ(shell.names(), "disc.h5\n");
}

TEST(DryRun, StepsOfATestAreForeseenWithinAFactorOfThree) {
    const Shell shell;
    shell.must("graincrack-mesh disc --diameter 80mm --grains 300 --quiet -o brazilian.h5");
    shell.must("graincrack-mesh rectangle --width 30mm --height 60mm --grains 300 --quiet -o tension.h5");
    for (const std::string test : {"brazilian", "tension"}) {
        const std::string command = "graincrack-solve " + test + " " + test + ".h5 --material augig-granite ";
        const double foreseen = std::stod(shell.must(command + "--dry-run | sed -n 's/^usual_steps\t//p'"));
        shell.must(command + "--quiet -o " + test + "-run.h5");
        const double steps = std::stod(cell(shell.must("graincrack-post strength " + test + "-run.h5"), "steps"));
        EXPECT_LT(std::abs(std::log(foreseen / steps)), std::log(3.0))
            << test << ": " << foreseen << " foreseen, " << steps << " made";
    }
}

}  // namespace
}  // namespace graincrack::test
