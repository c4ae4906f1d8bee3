#include "share/options/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/options/option_set.hpp"
#include "share/rock/material.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/rows.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

enum class Plane { strain, stress };

/// An example of a tool with two subcommands.
struct Tool {
    CommonOptions common;
    CommandLine line{"graincrack-try",
                     "A tool for tests",
                     common,
                     "  graincrack-try uniaxial a.h5 -o b.h5\n  graincrack-try triaxial a.h5 -o b.h5",
                     {"CGAL 5.5.1"}};
    int threads = 0;
    struct Options {
        std::vector<std::string> files;
        double edge = 0;
        std::optional<double> spread;
        std::optional<int> grains;
        double damping = 0;
        double pressure = -1;
        double max_strain = 0;
        std::optional<FractureEnergyChoice> fracture_energy;
        Plane plane = Plane::strain;
        std::string law = "scaled";
        std::uint64_t seed = 1;
        int frames = 20;
        bool deep = false;
        std::string output;
    } options;

    Tool() {
        add_threads(line.options(), threads);
        add_test("uniaxial", "0.015");
        const OptionSet triaxial = add_test("triaxial", "5%");
        add_quantity(triaxial, "--confining-pressure", options.pressure, quantity::confining_pressure,
                     "pressure on the lateral edges", "4MPa");
    }

    OptionSet add_test(const char* name, const char* max_strain) {
        OptionSet sub = line.options().add_subcommand(name, "a test");
        add_files(sub, "files", options.files, "specimen");
        const Option edge = add_quantity(sub, "--edge", options.edge, quantity::mean_edge, "mean edge", "5.13mm");
        add_quantity(sub, "--spread", options.spread, quantity::edge_spread, "spread");
        add_integer<int>(sub, "--grains", options.grains, "grains", 1).excludes(edge);
        add_quantity_or(sub, "--damping", options.damping, quantity::damping, "none", 0, "local damping", "0.8");
        add_fracture_energy(sub, options.fracture_energy, "fracture energy of a contact");
        add_choice<Plane>(sub, "--plane", options.plane, {{"strain", Plane::strain}, {"stress", Plane::stress}}, "plane");
        add_choice(sub, "--contact-law", options.law, {"literal", "scaled", "continuous"}, "law");
        add_integer<std::uint64_t>(sub, "--seed", options.seed, "seed", 0);
        add_integer<int>(sub, "--frames", options.frames, "frames", 1, 1000);
        add_flag(sub, "--deep", options.deep, "a flag");
        add_dry_run(sub, common, "print counts and stop");
        add_text(sub, "-o,--output", options.output, "run file").required();
        add_quantity(sub, "--max-strain", options.max_strain, quantity::max_strain, "end", max_strain);
        return sub;
    }

    bool parse(const std::string& text) {
        const auto words = split(text, ' ');
        return parse(text.empty() ? std::vector<std::string>{} : std::vector<std::string>(words.begin(), words.end()));
    }
    bool parse(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "graincrack-try");
        std::vector<const char*> argv;
        argv.reserve(arguments.size() + 1);
        for (const std::string& argument : arguments) argv.push_back(argument.c_str());
        argv.push_back(nullptr);
        return line.parse(static_cast<int>(arguments.size()), argv.data());
    }
};

/// What a call has read.
std::string text_of(const Tool& tool) {
    const Tool::Options& o = tool.options;
    const auto or_none = [](const auto& value) { return value ? fmt::format("{}", *value) : "none"; };
    return fmt::format(
        "files {}\nedge {}\nspread {}\ngrains {}\ndamping {}\nfracture energy {}\nplane {}\nlaw {}\nseed {}\nframes {}\n"
        "deep {}\noutput {}\ndry run {}\nquiet {}\nverbose {}",
        fmt::join(o.files, " "), o.edge, or_none(o.spread), or_none(o.grains), o.damping,
        o.fracture_energy ? fmt::format("{}", o.fracture_energy->value) : "none", o.plane == Plane::strain ? "strain" : "stress",
        o.law, o.seed, o.frames, o.deep, o.output, tool.common.dry_run, tool.common.verbosity == Verbosity::quiet,
        tool.common.verbosity == Verbosity::verbose);
}

class CommandLines : public testing::Test {
protected:
    [[nodiscard]] std::string write(const std::string& text) const {
        std::ofstream(folder.file("run.toml")) << text;
        return folder.file("run.toml");
    }
    /// What a call prints that it answers, as on a machine of three processors.
    static std::string printed(const std::string& arguments) {
        testing::internal::CaptureStdout();
        EXPECT_FALSE(Tool().parse(arguments));
        return std::regex_replace(testing::internal::GetCapturedStdout(), std::regex("(threads N? *= *)[0-9]+"), "$013");
    }

    test::TemporaryFolder folder;
};

TEST_F(CommandLines, ReadOptionsOfAllKinds) {
    Tool tool;
    ASSERT_TRUE(
        tool.parse("uniaxial a.h5 --edge 4mm --spread=10% --damping none --fracture-energy 90J/m2 --plane stress --contact-law "
                   "literal --seed 18446744073709551615 --frames 7 --deep --dry-run -o - --quiet --threads 3"));
    test::expect_golden(text_of(tool));
    EXPECT_EQ(tool.threads, 3);
}

TEST_F(CommandLines, HaveDefaults) {
    Tool tool;
    ASSERT_TRUE(tool.parse("triaxial - a.h5 -o b.h5"));
    test::expect_golden(text_of(tool));
    EXPECT_EQ(tool.options.pressure, 4e6);
    EXPECT_EQ(tool.threads, available_processors());
}

TEST_F(CommandLines, KeepDefaultsOfSubcommandsThatShareATarget) {
    for (const auto& [arguments, strain] :
         std::map<std::string, double>{{"uniaxial", 0.015}, {"triaxial", 0.05}, {"uniaxial --max-strain 1%", 0.01}}) {
        Tool tool;
        ASSERT_TRUE(tool.parse(arguments + " a.h5 -o b.h5"));
        EXPECT_EQ(tool.options.max_strain, strain) << arguments;
    }
}

TEST_F(CommandLines, NoteWhatABareNumberWasTakenFor) {
    const auto notes = [](const std::string& more) {
        testing::internal::CaptureStderr();
        EXPECT_TRUE(Tool().parse("uniaxial a.h5 -o b.h5 " + more));
        return testing::internal::GetCapturedStderr();
    };
    test::expect_golden(notes("--edge 80"));
    EXPECT_EQ(notes("--edge 80 --quiet"), "");
    EXPECT_EQ(notes("--edge 80mm --spread 0.1"), "");
    EXPECT_NE(notes("--verbose").find("max-strain"), std::string::npos);
}

TEST_F(CommandLines, AreRefusedWithOptionFaultAndRemedy) {
    const auto of_arguments = [](const std::string& text) { Tool().parse(text); };
    EXPECT_EQ(test::expect_refused<UsageError>("share/options/command_line.toml", of_arguments), 29U);
    const auto of_file = [&](const std::string& text) {
        const std::string file = write(text);
        try {
            Tool().parse("uniaxial a.h5 -o b.h5 --config " + file);
        } catch (const UsageError& error) {
            throw UsageError(std::regex_replace(error.what(), std::regex(file), "FILE"));
        }
    };
    EXPECT_EQ(test::expect_refused<UsageError>("share/options/configuration.toml", of_file), 10U);
    Tool tool;
    tool.line.options().add_subcommand("group", "holds others").add_subcommand("member", "one of them");
    std::string first, second;
    const OptionSet pair = tool.line.options().add_subcommand("pair", "two options");
    add_text(pair, "--first", first, "one").needs(add_text(pair, "--second", second, "the other"));
    test::GoldenRefusals().add_each<UsageError>({"group", "pair --first 2"}, [&](const char* call) { tool.parse(call); });
}

TEST_F(CommandLines, WinOverAFile) {
    const std::string file = write("edge = '1mm'\nframes = 11\n");
    Tool tool;
    ASSERT_TRUE(tool.parse("uniaxial a.h5 -o b --edge 3mm --config " + file));
    EXPECT_EQ(tool.options.edge, 0.003);
    EXPECT_EQ(tool.options.frames, 11);
    Tool other;  // with an option that excludes a key
    ASSERT_TRUE(other.parse("uniaxial a.h5 -o b --grains 1122 --config " + file));
    EXPECT_EQ(other.options.grains, 1122);
    EXPECT_EQ(other.options.edge, 0.00513);
}

TEST_F(CommandLines, ReadKeysAtTheTopForWhatRunsAndSectionsForTheirSubcommand) {
    const std::string file = write(
        "quiet = true\nthreads = 2\nedge = 0.001\nfiles = ['x.h5', 'y.h5']\noutput = 'z.h5'\ndeep = true\n[triaxial]\n"
        "edge = '2 mm'\nconfining-pressure = '8 MPa'\n[uniaxial]\nplane = 'stress'\n");
    Tool triaxial;
    ASSERT_TRUE(triaxial.parse({"triaxial", "--config", file}));
    test::expect_golden(text_of(triaxial));
    EXPECT_EQ(triaxial.options.pressure, 8e6);
    EXPECT_EQ(triaxial.threads, 2);
    Tool uniaxial;
    ASSERT_TRUE(uniaxial.parse({"--config", file, "uniaxial", "a.h5"}));
    EXPECT_EQ(uniaxial.options.edge, 0.001);
    EXPECT_EQ(uniaxial.options.plane, Plane::stress);
    EXPECT_EQ(uniaxial.options.files, std::vector<std::string>{"a.h5"});
}

TEST_F(CommandLines, LoadTheirEffectiveConfigurationAgain) {
    Tool first;
    ASSERT_TRUE(first.parse({"triaxial", "a \"b\".h5", "c\\d.h5", "--edge", "4.7mm", "--spread", "0.07", "--fracture-energy",
                             "mixed", "--seed", "18446744073709551615", "--deep", "-o", "ü.h5", "--quiet", "--threads", "2",
                             "--confining-pressure", "8e6"}));
    const std::string text = first.line.effective_configuration();
    test::expect_golden(text);
    Tool second;
    ASSERT_TRUE(second.parse({"triaxial", "--config", write(text)})) << text;
    EXPECT_EQ(second.line.effective_configuration(), text);
    EXPECT_EQ(text_of(second), text_of(first));
    EXPECT_EQ(second.options.pressure, first.options.pressure);
}

TEST_F(CommandLines, PrintAConfigurationThatLoadsAgain) {
    const std::string text = printed("triaxial --print-config --frames 9");
    test::expect_golden(text);
    EXPECT_EQ(printed("triaxial --print-config --config " + write(text)), text);
}

// A bound, a unit, a default and a meaning stand where an option is declared: help and --describe have the same.
TEST_F(CommandLines, PrintHelpAndDescriptionOfTheirOptions) {
    test::expect_golden(printed("--help"), "help");
    test::expect_golden(printed("triaxial --help-all"), "all help");
    const auto description = nlohmann::ordered_json::parse(printed("--describe"));
    EXPECT_EQ(description["program"], "graincrack-try");
    std::string options;
    for (const auto& part : {description, description["commands"][1]}) {
        for (const auto& option : part["options"]) {
            if (option["name"] != "threads") options += option.dump() + "\n";
        }
    }
    test::expect_golden(options, "description");
}

TEST_F(CommandLines, PrintVersionsOfLibraries) {
    const std::string version = printed("--version");
    EXPECT_EQ(version.compare(0, 15, "graincrack-try "), 0) << version;
    EXPECT_NE(version.find("HDF5 "), std::string::npos);
    EXPECT_NE(version.find("\nCGAL 5.5.1\nCLI11 2"), std::string::npos);
}

TEST_F(CommandLines, CountAvailableProcessors) {
    cpu_set_t before;
    ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
    EXPECT_GE(available_processors(), 1);
    EXPECT_LE(available_processors(), CPU_COUNT(&before));
    cpu_set_t one;
    CPU_ZERO(&one);
    for (int i = 0; i < CPU_SETSIZE; ++i) {
        if (CPU_ISSET(i, &before) && CPU_COUNT(&one) == 0) CPU_SET(i, &one);
    }
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    EXPECT_EQ(available_processors(), 1);
    sched_setaffinity(0, sizeof before, &before);
}

}  // namespace
}  // namespace graincrack
