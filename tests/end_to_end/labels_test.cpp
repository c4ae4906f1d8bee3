// What the tools say beside their numbers.
#include <gtest/gtest.h>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Labels, ANotchThatCameOutDifferentlyIsSaidWhereTheToughnessIsRead) {
    const Shell shell;
    const Outcome mesh =
        shell.run("graincrack-mesh rectangle --width 20mm --height 40mm --edge 2.5mm --slit 6mm -v -o notched.h5");
    EXPECT_NE(mesh.err.find("slit of 6 mm requested, "), std::string::npos) << mesh.err;
    shell.must("graincrack-solve tension notched.h5 -o tension.h5 --peak-drop 0.01" + past_peak);
    const Outcome outcome = shell.run("graincrack-post toughness tension.h5");
    EXPECT_EQ(cell(outcome.out, "requested_notch_mm"), "6");
    const double notch = std::atof(cell(outcome.out, "notch_mm").c_str());
    const bool differs = std::abs(notch / 6 - 1) > 0.05;
    EXPECT_TRUE(differs) << notch << ": choose another seed";
    EXPECT_NE(outcome.err.find("where 6.0 mm was requested"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("a/l_ch is "), std::string::npos) << outcome.err;  // 3 mm over some 4 mm
    // The digest is that of a run without the record of its specimen's options, which is provenance.
    EXPECT_EQ(shell.must("graincrack-post info tension.h5 --digest | cut -c 1-64").size(), 65U);
}

// `script` is a terminal to the command that it runs.
TEST(Labels, ATerminalHasTablesForPeopleAndAPipeThoseForScripts) {
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o specimen.h5\n"
        "graincrack-solve uniaxial specimen.h5 -o run.h5 --mass-scaling none" +
        past_peak);
    for (const char* command : {"strength", "moduli"}) {
        const std::string call = std::string("graincrack-post --quiet ") + command + " run.h5";
        const std::string piped = shell.must(call + " | cat");
        EXPECT_TRUE(piped.starts_with("file\t")) << piped;
        EXPECT_EQ(n_lines(piped), 2);
        const std::string seen = shell.must("script --quiet --return --command '" + call + "' /dev/null | tr -d '\\r'");
        EXPECT_TRUE(seen.starts_with("run ")) << seen;
        EXPECT_NE(seen.find("plane strain"), std::string::npos) << seen;
        EXPECT_EQ(shell.must(call + " --format table"), seen);
        EXPECT_EQ(shell.must("script --quiet --return --command '" + call + " --format tsv' /dev/null | tr -d '\\r'"), piped);
    }
}

}  // namespace
}  // namespace graincrack::test
