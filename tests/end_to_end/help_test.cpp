// The examples of --help are commands that run.
#include <functional>
#include <regex>
#include <vector>

#include "share/rock/contact_parameters.hpp"
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

// Pages of a program and of each of its commands, nested ones too.
TEST(ManPages, HaveTheSectionsThatReadersLookFor) {
    const Shell shell;
    shell.must(GRAINCRACK_SOURCE "/share/packaging/man-pages $(command -v graincrack-post) pages");
    const std::string plot = shell.must("gzip -dc pages/graincrack-post-plot-cracks.1.gz");
    for (const char* section : {"NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS", "ENVIRONMENT", "FILES", "EXAMPLES", "SEE ALSO"}) {
        EXPECT_NE(plot.find(std::string("\n.SH ") + section + "\n"), std::string::npos) << section;
    }
    EXPECT_NE(plot.find("\n.SH EXAMPLES\n.nf\ngraincrack\\-post plot cracks "), std::string::npos) << plot;
    const std::string tool = shell.must("gzip -dc pages/graincrack-post.1.gz");
    EXPECT_NE(tool.find("graincrack\\-post\\-strength\\fR(1)"), std::string::npos) << tool;
}

/// The command lines under "Examples:".
std::vector<std::string> examples_of(const std::string& help) {
    std::vector<std::string> examples;
    std::istringstream lines(help.substr(std::min(help.size(), help.find("\nExamples:\n"))));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("  graincrack-")) examples.push_back(line.substr(2));
    }
    return examples;
}

TEST(Help, ExamplesOfTheMesherRun) {
    const Shell shell;
    const auto examples = examples_of(shell.must("graincrack-mesh --help"));
    ASSERT_EQ(examples.size(), 6u);
    const std::string folder = GRAINCRACK_SOURCE "/share/doc/specimens/";
    shell.must("cp " + folder + "vein.msh section.msh; cp " + folder + "thin-section.png .; cp " + folder +
               "thin-section.tsv minerals.tsv");
    for (const std::string& example : examples) shell.must(example);
    EXPECT_EQ(shell.names(),
              "disc.h5\nlabels.tsv\nminerals.h5\nminerals.tsv\nsection.h5\nsection.msh\nspecimen.h5\nthin-section.png\n");
}

TEST(Help, ExamplesOfTheSolverAreRight) {
    const Shell shell;
    const auto examples = examples_of(shell.must("graincrack-solve --help"));
    ASSERT_EQ(examples.size(), 2u);
    shell.must("graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o specimen.h5");
    for (const std::string& example : examples) {
        shell.must(example + " --dry-run");  // the runs themselves would take minutes
        shell.must(example + " --max-strain 0.0003" + (example.find("--rate") == std::string::npos ? " --rate 400mm/s" : ""));
    }
    EXPECT_EQ(shell.names(), "specimen.h5\ntriaxial.h5\nuniaxial.h5\n");
}

TEST(Help, EveryContactParameterIsAnOptionAndSaysWhatItIsUnlessGiven) {
    const Shell shell;
    std::string help = shell.must("graincrack-solve uniaxial --help-all | tr -s ' \\n' ' '");
    for (const ContactParameter& row : all_contact_parameters()) {
        const std::size_t at = help.find(row.option() + " ");
        ASSERT_NE(at, std::string::npos) << row.option();
        const std::string own = help.substr(at, help.find(" --", at + 1) - at);
        EXPECT_NE(own.find(row.quantity.meaning), std::string::npos) << own;
        EXPECT_NE(own.find(row.is_needed() ? "default: the material's [" : std::string("else ") + row.usual), std::string::npos)
            << own;
    }
}

/// The lines `name   what it is` under "Subcommands:".
std::vector<std::string> subcommands_of(const std::string& help) {
    std::vector<std::string> names;
    std::istringstream lines(help.substr(std::min(help.size(), help.find("\nSubcommands:\n"))));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("  ") && line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
        if (line.empty() && !names.empty()) break;
    }
    return names;
}

TEST(Help, EverySubcommandExplainsItself) {
    const Shell shell;
    for (const std::string tool : {"graincrack-mesh ", "graincrack-solve "}) {
        const std::vector<std::string> names = subcommands_of(shell.must(tool + "--help"));
        EXPECT_GE(names.size(), 2u);
        for (const std::string& name : names) {
            const Outcome outcome = shell.run(tool + name + " --help");
            EXPECT_EQ(outcome.exit_code, 0) << name;
            EXPECT_EQ(outcome.err, "") << name;
            EXPECT_NE(outcome.out.find("Usage: graincrack-"), std::string::npos) << name;
            EXPECT_GE(examples_of(outcome.out).size(), 2u) << name;
        }
    }
}

/// The long names of the options under "Options:".
std::vector<std::string> options_of(const std::string& help) {
    std::vector<std::string> names;
    static const std::regex option(R"(\n  (?:-\w,)?(--[\w-]+))");
    const std::size_t at = help.find("\nOptions:\n");
    const std::string own = help.substr(at, help.find("\n\n", at) - at);
    for (std::sregex_iterator each(own.begin(), own.end(), option), end; each != end; ++each) names.push_back((*each)[1]);
    return names;
}

TEST(Help, ShowsTheOptionsThatPeopleUseAndAllOnRequest) {
    const Shell shell;
    std::function<void(const std::string&)> check = [&](const std::string& command) {
        const std::string help = shell.must(command + " --help");
        const auto below = subcommands_of(help);
        for (const std::string& name : below) check(command + " " + name);
        if (!below.empty()) return;
        EXPECT_LE(options_of(help).size(), 12U) << help;  // ten, --help and --help-all
        const std::string all = shell.must(command + " --help-all");
        EXPECT_NE(all.find("\n  --print-config "), std::string::npos) << all;
        EXPECT_EQ(all.find("401"), std::string::npos) << all;
        EXPECT_FALSE(std::regex_search(all, std::regex("e\\+0\\d; %|at most 1\\d+")));
    };
    for (const char* tool : {"graincrack-mesh", "graincrack-solve", "graincrack-post"}) check(tool);
    EXPECT_EQ(
        options_of(shell.must("graincrack-solve triaxial --help")),
        (std::vector<std::string>{"--help", "--help-all", "--material", "--plane", "--confining-pressure", "--rate-tolerance",
                                  "--max-strain", "--checkpoint-every", "--restart", "--frames", "--threads", "--output"}));
    EXPECT_GT(options_of(shell.must("graincrack-solve triaxial --help-all")).size(), 35U);
}

TEST(Help, ExamplesOfThePostprocessorAndOfEachOfItsCommandsRun) {
    const Shell shell;
    // A drop of 1 % below the largest stress counts as a peak here, because tests so small and fast have no larger one.
    const std::string test =
        " --material augig-granite --mass-scaling none --rate 400mm/s --max-strain 0.03 --peak-drop 0.01 --quiet ";
    shell.must(
        "graincrack-mesh disc --diameter 30mm --edge 5mm --quiet -o disc.h5\n"
        "graincrack-mesh disc --diameter 30mm --grains 30 --quiet -o coarse.h5\n"
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o rectangle.h5\n"
        "graincrack-solve brazilian disc.h5 -o brazilian.h5" +
        test + "\ngraincrack-solve brazilian coarse.h5 -o brazilian-coarse.h5" + test +
        "\ngraincrack-solve uniaxial rectangle.h5 -o uniaxial.h5" + test +
        "\ngraincrack-solve uniaxial rectangle.h5 -o weak.h5 --contact-cohesion 60MPa" + test +
        "\ngraincrack-solve uniaxial rectangle.h5 -o default.h5" + test +
        "\ngraincrack-solve uniaxial rectangle.h5 -o half-as-fast.h5" + std::regex_replace(test, std::regex("400mm"), "320mm") +
        "\ngraincrack-solve triaxial rectangle.h5 -o triaxial.h5 --confining-pressure 1MPa" + test +
        "\ngraincrack-mesh rectangle --width 20mm --height 40mm --edge 2.5mm --slit 6mm --quiet -o notched.h5"
        "\ngraincrack-solve tension notched.h5 -o notched-tension.h5" +
        test +
        "\ngraincrack-post strength brazilian.h5 brazilian-coarse.h5 uniaxial.h5 weak.h5 >strength.tsv\n"
        "cp " GRAINCRACK_TEST_DATA
        "/table7.csv .\n"
        "mkdir -p results/my-rock\ncp " GRAINCRACK_SOURCE
        "/share/materials/augig-granite.toml results/my-rock/material.toml\n"
        "printf 'axial_strain\\tstress_MPa\\n0\\t0\\n0.002\\t60\\n' >measured.tsv");
    for (const std::string& example : examples_of(shell.must("graincrack-post --help"))) shell.must(example);
    std::vector<std::string> commands;
    for (const std::string& name : subcommands_of(shell.must("graincrack-post --help"))) {
        const auto nested = subcommands_of(shell.must("graincrack-post " + name + " --help"));
        for (const std::string& own : nested) commands.push_back(name + " " + own);
        if (nested.empty()) commands.push_back(name);
    }
    EXPECT_GE(commands.size(), 30u);
    for (const std::string& example : examples_of(shell.must("graincrack-post --help"))) shell.must(example);
    for (const std::string& command : commands) {
        const auto examples = examples_of(shell.must("graincrack-post " + command + " --help"));
        EXPECT_GE(examples.size(), 2u) << command;
        for (const std::string& example : examples) {
            EXPECT_TRUE(example.starts_with("graincrack-post " + command + " ")) << example;
            shell.must(example);
        }
    }
}

TEST(Help, CompletionOffersWhatFits) {
    const Shell shell;
    const auto offered = [&](const std::string& tool, const std::string& line) {
        return shell.must("bash -c 'source <(graincrack-" + tool + " --completion bash); COMP_WORDS=(" + line +
                          "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _graincrack_" + tool + "; echo \"${COMPREPLY[*]}\"'");
    };
    EXPECT_EQ(offered("solve", "graincrack-solve un"), "uniaxial\n");
    EXPECT_EQ(offered("solve", "graincrack-solve uniaxial specimen.h5 --mass-scaling \"\""), "none selective\n");
    EXPECT_EQ(offered("solve", "graincrack-solve triaxial --conf"), "--config --confining-pressure\n");
    EXPECT_EQ(offered("solve", "graincrack-solve uniaxial --confi"), "--config\n");
    EXPECT_EQ(offered("post", "graincrack-post plot lenn"), "lennard-jones\n");
    EXPECT_EQ(offered("mesh", "graincrack-mesh rectangle --wid"), "--width\n");
    EXPECT_EQ(offered("mesh", "graincrack-mesh disc --wid"), "\n");
    for (const char* tool : {"mesh", "solve", "post"}) {
        shell.must(std::string("graincrack-") + tool + " --completion bash | bash -n");
        EXPECT_TRUE(shell.must(std::string("graincrack-") + tool + " --completion zsh").starts_with("#compdef graincrack-"));
    }
    const Outcome unknown = shell.run("graincrack-solve --completion fish");
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_EQ(unknown.err, "graincrack-solve: --completion: unknown shell \"fish\"; one of bash|zsh fits\n");
}

TEST(Help, EverySubcommandOfMesherAndSolverExplainsItself) {
    const Shell shell;
    for (const std::string tool : {"graincrack-mesh", "graincrack-solve"}) {
        for (const std::string& name : subcommands_of(shell.must(tool + " --help"))) {
            EXPECT_GE(examples_of(shell.must(tool + " " + name + " --help")).size(), 2u) << name;
        }
    }
}

TEST(Help, VersionNamesToolAndLibraries) {
    const Shell shell;
    for (const auto& [tool, library] : {std::pair{"mesh", "CGAL"}, {"solve", "HDF5"}, {"post", "VTK"}}) {
        const std::string text = shell.must(std::string("graincrack-") + tool + " --version");
        EXPECT_TRUE(text.starts_with(std::string("graincrack-") + tool + " 0.")) << text;
        EXPECT_NE(text.find(library), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace graincrack::test
