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
