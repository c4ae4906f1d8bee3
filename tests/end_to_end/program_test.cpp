// Loading programs from the command line.
#include <cmath>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string solve = "graincrack-solve program bar.h5 --material augig-granite --quiet ";

/// A small bar and a pulse through it.
void lay_out(const Shell& shell) {
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
    lay_out(shell);
    shell.must(solve + "--program pulse.toml --damping none -o run.h5");
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
    EXPECT_NE(shell.must(solve + "--program pulse.toml --damping 0.1 --dry-run").find("max_steps"), std::string::npos);
}

TEST(Programs, WhatDoesNotFitIsOneLine) {
    const Shell shell;
    lay_out(shell);
    const auto refused = [&](const std::string& options, int exit_code, const std::string& named) {
        const Outcome outcome = shell.run(solve + options + " -o run.h5");
        EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
    };
    refused("--program pulse.toml", 2, "--damping: missing");
    refused("--program pulse.toml --damping 0.8 --mass-scaling selective", 2,
            "--mass-scaling: pulse.toml is dynamic (boundary.source");
    refused("--program none.toml --damping none", 3, "none.toml: cannot be read");
    shell.must("sed 's/\"left\"/\"lefft\"/' pulse.toml >part.toml; sed 's/19 mm/21 mm/' pulse.toml >point.toml");
    refused("--program part.toml --damping none", 3, "part.toml: boundary.source: on: the specimen has no boundary part lefft");
    refused("--program point.toml --damping none", 3, "point.toml: probe.end: the point lies in no element");
    EXPECT_EQ(shell.names(), "bar.h5\npart.toml\npoint.toml\npulse.toml\n");
}

}  // namespace
}  // namespace graincrack::test
