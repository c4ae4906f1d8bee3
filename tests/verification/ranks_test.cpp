// Large runs of several ranks, and runs with every law, are the runs of one process.
#include <gtest/gtest.h>

#include <string>

#include "solver/law/table.hpp"
#include "tests/end_to_end/ranks.hpp"

namespace graincrack::test {
namespace {

class LargeRanks : public OnRanks {};

constexpr int time_limit = 400;  // s

TEST_F(LargeRanks, BreakFiveThousandGrainsUnderPressure) {
    const Shell shell;
    const std::string solve =
        "graincrack-solve triaxial specimen.h5 --material augig-granite --confining-pressure 5MPa --rate-tolerance 0.1 "
        "--rate-share 6 --max-strain 0.02 --save-state --quiet ";
    shell.must("graincrack-mesh rectangle --width 50mm --height 100mm --grains 5000 --quiet -o specimen.h5\n" + solve +
               "--threads 2 -o one.h5");
    const Extent extent = extent_of(shell, "one.h5");
    EXPECT_GT(extent.cracks, 5000U);
    EXPECT_GT(extent.active_node_edge_contacts, 5000U);
    EXPECT_GT(extent.friction, 0);
    shell.must(on_ranks(2, time_limit) + solve + "--threads 2 -o two.h5");
    expect_same_run(shell, "two.h5", "one.h5");
    shell.must(on_ranks(4, time_limit) + solve + "-o four.h5");
    expect_same_run(shell, "four.h5", "one.h5");
}

// Crystals of three minerals that break beside flaws: loaded up to the peak, then unloaded and crushed by a program of its own.
TEST_F(LargeRanks, ContinueAProgramOnOtherNumbersOfThem) {
    const Shell shell;
    write_text(shell.file("phases.toml"), R"(
[phases]
quartz = { fraction = 0.4, relative_young_modulus = 1.4 }
feldspar = { fraction = 0.4 }
mica = { fraction = 0.2, relative_young_modulus = 0.4 }
[pairs]
within = { tensile_strength = 1.25, cohesion = 1.25 }
[flaws.vein]
tensile_strength = "1 MPa"
cohesion = "2 MPa"
fracture_energy = "4 J/m2"
)");
    write_text(shell.file("flaws.tsv"), "x1_mm\ty1_mm\tx2_mm\ty2_mm\tclass\n-12\t-16\t8\t4\tbroken\n-4\t8\t14\t22\tvein\n");
    const std::string head = R"(
name = "unload and crush"
damping = 0.8
[platens]
[boundary.membrane]
on = ["left", "right"]
[probe.core]
circle = ["0 mm", "0 mm", "10 mm"]
)";
    write_text(shell.file("first.toml"), R"(stages = ["confine", "press"])" + head + R"(
[stage.confine]
membrane.pressure = { to = "5 MPa", over = "0.1 ms" }
platen_pressure = { to = "5 MPa", over = "0.1 ms" }
until.time = "0.15 ms"
[stage.press]
platen_speed = { auto = "together", tolerance = 0.03 }
until = { peak_drop = 0.1, time = "1 ms" }
)");
    write_text(shell.file("second.toml"), R"(stages = ["ease", "crush"])" + head + R"(
[stage.ease]
membrane.pressure = "keep"
platen_speed = { to = "-0.5 m/s", over = "0.05 ms" }
until.time = "0.1 ms"
[stage.crush]
membrane.pressure = "keep"
platen_speed = { to = "2 m/s", over = "0.05 ms" }
until.time = "0.5 ms"
)");
    shell.must("cat " GRAINCRACK_SOURCE
               "/share/materials/augig-granite.toml phases.toml >minerals.toml\n"
               "graincrack-mesh rectangle --width 40mm --height 80mm --grains 300 --tessellation trigon --flaws flaws.tsv "
               "--material minerals.toml --quiet -o specimen.h5");
    const std::string solve = "graincrack-solve program specimen.h5 --material minerals.toml --save-state --quiet --program ";
    const std::string second = solve + "second.toml --restart ";
    shell.must(solve + "first.toml -o first.h5\n" + second + "first.h5 --threads 2 -o second.h5");
    const Extent extent = extent_of(shell, "second.h5");
    EXPECT_GT(extent.cracks, 2000U);
    EXPECT_GT(extent.active_node_edge_contacts, 5000U);
    shell.must(on_ranks(4, time_limit) + solve + "first.toml -o first-4.h5");
    expect_same_run(shell, "first-4.h5", "first.h5");
    for (const int n : {2, 3}) {
        const std::string run = "second-" + std::to_string(n) + ".h5";
        shell.must(on_ranks(n, time_limit) + second + "first-4.h5 -o " + run);
        expect_same_run(shell, run, "second.h5");
    }
}

TEST_F(LargeRanks, CrushGrainsOfEveryLaw) {
    const Shell shell;
    shell.must("graincrack-mesh rectangle --width 20mm --height 40mm --grains 300 --quiet -o specimen.h5");
    for (const LawDescription& law : all_contact_laws()) {
        SCOPED_TRACE(law.name);
        for (const std::string options : {"selective --rate 2m/s --max-strain 0.04 ", "none --rate 8m/s --max-strain 0.02 "}) {
            const std::string solve =
                "graincrack-solve uniaxial specimen.h5 --material augig-granite --peak-drop none --save-state --quiet "
                "--contact-law " +
                std::string(law.name) + " --mass-scaling " + options;
            shell.must(solve + "-o one.h5\n" + on_ranks(4, time_limit) + solve + "-o four.h5");
            const Extent extent = extent_of(shell, "one.h5");
            EXPECT_GT(extent.cracks, 100U);
            EXPECT_GT(extent.active_node_edge_contacts, 100U);
            EXPECT_GT(extent.friction, 0);
            expect_same_run(shell, "four.h5", "one.h5");
        }
    }
}

}  // namespace
}  // namespace graincrack::test
