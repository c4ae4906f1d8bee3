#include "share/options/command_line.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/options/option_set.hpp"
#include "share/rock/material.hpp"
#include "tests/support/rows.hpp"

namespace graincrack {
namespace {

namespace fs = std::filesystem;

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

class CommandLines : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("graincrack-command-line-" + std::to_string(getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    std::string write(const std::string& text) {
        const fs::path file = folder / "run.toml";
        std::ofstream(file) << text;
        return file.string();
    }
    /// The error message for these arguments.
    static std::string complaint(const std::string& arguments) {
        try {
            Tool().parse(arguments);
        } catch (const UsageError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            EXPECT_LT(std::string(error.what()).size(), 500U);
            return error.what();
        }
        return "nothing wrong";
    }
    /// The error message for a configuration file, with `FILE` in place of its name.
    std::string complaint_about_file(const std::string& text, const std::string& subcommand = "uniaxial") {
        const std::string file = write(text);
        std::string message = complaint(subcommand + " a.h5 -o b.h5 --config " + file);
        for (auto at = message.find(file); at != std::string::npos; at = message.find(file)) {
            message.replace(at, file.size(), "FILE");
        }
        return message;
    }

    fs::path folder;
};

TEST_F(CommandLines, OptionsOfAllKinds) {
    Tool tool;
    ASSERT_TRUE(
        tool.parse("uniaxial a.h5 --edge 4mm --spread=10% --damping none --fracture-energy 90J/m2 --plane stress --contact-law "
                   "literal --seed 18446744073709551615 --frames 7 --deep --dry-run -o - --quiet --threads 3"));
    EXPECT_EQ(tool.options.files, std::vector<std::string>{"a.h5"});
    EXPECT_EQ(tool.options.edge, 0.004);
    EXPECT_EQ(tool.options.spread, 0.1);
    EXPECT_FALSE(tool.options.grains);
    EXPECT_EQ(tool.options.damping, 0);
    ASSERT_TRUE(tool.options.fracture_energy);
    EXPECT_EQ(tool.options.fracture_energy->value, 90);
    EXPECT_EQ(tool.options.plane, Plane::stress);
    EXPECT_EQ(tool.options.law, "literal");
    EXPECT_EQ(tool.options.seed, 18446744073709551615U);
    EXPECT_EQ(tool.options.frames, 7);
    EXPECT_TRUE(tool.options.deep);
    EXPECT_TRUE(tool.common.dry_run);
    EXPECT_EQ(tool.options.output, "-");
    EXPECT_EQ(tool.common.verbosity, Verbosity::quiet);
    EXPECT_EQ(tool.threads, 3);
}

TEST_F(CommandLines, Defaults) {
    Tool tool;
    ASSERT_TRUE(tool.parse("triaxial - a.h5 -o b.h5"));
    EXPECT_EQ(tool.options.files, (std::vector<std::string>{"-", "a.h5"}));
    EXPECT_EQ(tool.options.edge, 0.00513);
    EXPECT_FALSE(tool.options.spread);
    EXPECT_EQ(tool.options.damping, 0.8);
    EXPECT_EQ(tool.options.pressure, 4e6);
    EXPECT_FALSE(tool.options.fracture_energy);
    EXPECT_EQ(tool.options.frames, 20);
    EXPECT_EQ(tool.common.verbosity, Verbosity::normal);
    EXPECT_EQ(tool.threads, available_processors());
}

TEST_F(CommandLines, SubcommandsShareATargetAndKeepTheirOwnDefaults) {
    Tool uniaxial;
    ASSERT_TRUE(uniaxial.parse("uniaxial a.h5 -o b.h5"));
    EXPECT_EQ(uniaxial.options.max_strain, 0.015);
    Tool triaxial;
    ASSERT_TRUE(triaxial.parse("triaxial a.h5 -o b.h5"));
    EXPECT_EQ(triaxial.options.max_strain, 0.05);
    Tool given;
    ASSERT_TRUE(given.parse("uniaxial a.h5 -o b.h5 --max-strain 1%"));
    EXPECT_EQ(given.options.max_strain, 0.01);
}

TEST_F(CommandLines, NotesSayWhatABareNumberWasTakenFor) {
    const auto notes = [](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"uniaxial", "a.h5", "-o", "b.h5"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        testing::internal::CaptureStderr();
        Tool tool;
        EXPECT_TRUE(tool.parse(arguments));
        return testing::internal::GetCapturedStderr();
    };
    EXPECT_EQ(notes({"--edge", "80"}), "graincrack-try: note: --edge: 80 has no unit and was taken for 80 m\n");
    EXPECT_EQ(notes({"--edge", "80", "--quiet"}), "");
    EXPECT_EQ(notes({"--edge", "80mm", "--spread", "0.1"}), "");
    EXPECT_NE(notes({"--verbose"}).find("max-strain"), std::string::npos);
}

TEST_F(CommandLines, ComplaintsNameOptionFaultAndRemedy) {
    const auto of_arguments = [](const std::string& text) { throw UsageError(complaint(text)); };
    EXPECT_EQ(test::expect_refused<UsageError>("share/options/command_line.toml", of_arguments), 29U);
    const auto of_file = [&](const std::string& text) { throw UsageError(complaint_about_file(text)); };
    EXPECT_EQ(test::expect_refused<UsageError>("share/options/configuration.toml", of_file), 10U);
}

TEST_F(CommandLines, WhatIsMissingIsSaidInTheOrderOfTheCall) {
    Tool nested;
    nested.line.options().add_subcommand("group", "holds others").add_subcommand("member", "one of them");
    try {
        nested.parse("group");
        FAIL() << "nothing wrong";
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "no subcommand given; one of member fits");
    }
}

TEST_F(CommandLines, AnOptionThatNeedsAnother) {
    Tool tool;
    std::string first;
    std::string second;
    const OptionSet pair = tool.line.options().add_subcommand("pair", "two options");
    add_text(pair, "--first", first, "one").needs(add_text(pair, "--second", second, "the other"));
    try {
        tool.parse("pair --first 2");
        FAIL() << "nothing wrong";
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "--first: not alone; give --second as well");
    }
}

TEST_F(CommandLines, FlagsWinOverTheFile) {
    const std::string file = write("edge = '1mm'\nframes = 11\n");
    Tool tool;
    ASSERT_TRUE(tool.parse({"uniaxial", "a.h5", "-o", "b", "--config", file, "--edge", "3mm"}));
    EXPECT_EQ(tool.options.edge, 0.003);
    EXPECT_EQ(tool.options.frames, 11);
}

TEST_F(CommandLines, KeysAtTheTopBelongToWhatRunsAndSectionsToTheirSubcommand) {
    const std::string file = write(
        "quiet = true\nthreads = 2\nedge = 0.001\nfiles = ['x.h5', 'y.h5']\noutput = 'z.h5'\ndeep = true\n[triaxial]\n"
        "edge = '2 mm'\nconfining-pressure = '8 MPa'\n[uniaxial]\nplane = 'stress'\n");
    Tool triaxial;
    ASSERT_TRUE(triaxial.parse({"triaxial", "--config", file}));
    EXPECT_EQ(triaxial.options.edge, 0.002);
    EXPECT_EQ(triaxial.options.pressure, 8e6);
    EXPECT_EQ(triaxial.options.plane, Plane::strain);
    EXPECT_EQ(triaxial.options.files, (std::vector<std::string>{"x.h5", "y.h5"}));
    EXPECT_EQ(triaxial.options.output, "z.h5");
    EXPECT_TRUE(triaxial.options.deep);
    EXPECT_EQ(triaxial.common.verbosity, Verbosity::quiet);
    EXPECT_EQ(triaxial.threads, 2);
    Tool uniaxial;
    ASSERT_TRUE(uniaxial.parse({"--config", file, "uniaxial", "a.h5"}));
    EXPECT_EQ(uniaxial.options.edge, 0.001);
    EXPECT_EQ(uniaxial.options.plane, Plane::stress);
    EXPECT_EQ(uniaxial.options.files, std::vector<std::string>{"a.h5"});
}

TEST_F(CommandLines, AKeyGivesWayToAFlagThatExcludesIt) {
    const std::string file = write("edge = '4mm'\n");
    Tool tool;
    ASSERT_TRUE(tool.parse({"uniaxial", "a.h5", "-o", "b", "--config", file, "--grains", "1122"}));
    EXPECT_EQ(tool.options.grains, 1122);
    EXPECT_EQ(tool.options.edge, 0.00513);
}

TEST_F(CommandLines, TheEffectiveConfigurationLoadsAgain) {
    Tool first;
    ASSERT_TRUE(first.parse({"triaxial", "a \"b\".h5", "c\\d.h5", "--edge", "4.7mm", "--spread", "0.07", "--fracture-energy",
                             "mixed", "--seed", "18446744073709551615", "--deep", "-o", "ü.h5", "--quiet", "--threads", "2",
                             "--confining-pressure", "8e6"}));
    const std::string text = first.line.effective_configuration();
    EXPECT_NE(text.find("\n[triaxial]\n"), std::string::npos) << text;
    EXPECT_NE(text.find("# grains ="), std::string::npos) << text;

    Tool second;
    ASSERT_TRUE(second.parse({"triaxial", "--config", write(text)})) << text;
    EXPECT_EQ(second.options.files, first.options.files);
    EXPECT_EQ(second.options.edge, first.options.edge);
    EXPECT_EQ(second.options.spread, first.options.spread);
    EXPECT_EQ(second.options.fracture_energy->kind, first.options.fracture_energy->kind);
    EXPECT_EQ(second.options.seed, first.options.seed);
    EXPECT_EQ(second.options.deep, first.options.deep);
    EXPECT_EQ(second.options.output, first.options.output);
    EXPECT_EQ(second.options.pressure, first.options.pressure);
    EXPECT_EQ(second.options.damping, first.options.damping);
    EXPECT_EQ(second.options.law, first.options.law);
    EXPECT_EQ(second.common.verbosity, first.common.verbosity);
    EXPECT_EQ(second.threads, first.threads);
    EXPECT_EQ(second.line.effective_configuration(), text);
}

TEST_F(CommandLines, PrintConfigNeedsNothingElseAndLoadsAgain) {
    testing::internal::CaptureStdout();
    Tool tool;
    EXPECT_FALSE(tool.parse("triaxial --print-config --frames 9"));
    const std::string text = testing::internal::GetCapturedStdout();
    EXPECT_NE(text.find("frames = 9\n"), std::string::npos) << text;
    EXPECT_NE(text.find("# output =\n"), std::string::npos) << text;
    EXPECT_NE(text.find("edge = \"5.13mm\"\n"), std::string::npos) << text;

    testing::internal::CaptureStdout();
    Tool again;
    EXPECT_FALSE(again.parse({"triaxial", "--print-config", "--config", write(text)}));
    EXPECT_EQ(testing::internal::GetCapturedStdout(), text);
}

TEST_F(CommandLines, HelpShowsUnitsDefaultsAndExamples) {
    testing::internal::CaptureStdout();
    EXPECT_FALSE(Tool().parse("triaxial --help-all"));
    const std::string help = testing::internal::GetCapturedStdout();
    for (const char* part :
         {"--edge LENGTH = 5.13mm", "[m, mm, cm, um, km]", "--confining-pressure STRESS = 4MPa", "--plane strain|stress = strain",
          "--damping NUMBER|none = 0.8", "-o,--output TEXT REQUIRED", "--frames N = 20",
          "Options of graincrack-try:", "--config FILE", "--threads N", "Examples:\n  graincrack-try uniaxial a.h5 -o b.h5"}) {
        EXPECT_NE(help.find(part), std::string::npos) << part << "\n" << help;
    }
    EXPECT_EQ(help.find("(Env:"), std::string::npos);

    testing::internal::CaptureStdout();
    EXPECT_FALSE(Tool().parse("--help"));
    EXPECT_NE(testing::internal::GetCapturedStdout().find("triaxial"), std::string::npos);
}

// A bound, a unit, a default and a meaning stand where an option is declared: help and --describe have the same.
TEST_F(CommandLines, DescriptionHasWhatAnOptionIsDeclaredWith) {
    testing::internal::CaptureStdout();
    EXPECT_FALSE(Tool().parse("--describe"));
    const std::string description = testing::internal::GetCapturedStdout();
    EXPECT_TRUE(description.starts_with(R"({"program":"graincrack-try","version":")")) << description.substr(0, 100);
    for (const char* part :
         {R"({"name":"quiet","short":"q","type":"flag","excludes":["verbose"],"usual":true,"meaning":"print errors only"})",
          R"({"name":"files","positional":true,"type":"file","many":true,"usual":true,"meaning":"specimen"})",
          R"({"name":"edge","type":"quantity","unit":"m","units":["m","mm","cm","um","km"],"minimum":0.0,"maximum":1000.0,)"
          R"("exclusive_minimum":true,"default":"5.13mm","excludes":["grains"],"usual":true,)"
          R"("meaning":"mean edge [m, mm, cm, um, km]"})",
          R"({"name":"grains","type":"integer","minimum":1,"excludes":["edge"],"usual":true,"meaning":"grains"})",
          R"("maximum":0.99,"choices":["none"],"default":"0.8",)", R"("choices":["mixed","mode-i"],)",
          R"({"name":"plane","type":"choice","choices":["strain","stress"],"default":"strain",)",
          R"({"name":"frames","type":"integer","minimum":1,"maximum":1000,"default":"20",)",
          R"({"name":"output","short":"o","type":"text","required":true,)", R"({"name":"triaxial","description":"a test",)"}) {
        EXPECT_NE(description.find(part), std::string::npos) << part << " is not in " << description;
    }
}

TEST_F(CommandLines, VersionShowsLibraries) {
    testing::internal::CaptureStdout();
    EXPECT_FALSE(Tool().parse("--version"));
    const std::string version = testing::internal::GetCapturedStdout();
    EXPECT_EQ(version.compare(0, 15, "graincrack-try "), 0) << version;
    EXPECT_NE(version.find("HDF5 "), std::string::npos);
    EXPECT_NE(version.find("\nCGAL 5.5.1\nCLI11 2"), std::string::npos);
}

TEST_F(CommandLines, AvailableProcessors) {
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
