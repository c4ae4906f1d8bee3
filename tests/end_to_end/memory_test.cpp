// Commands read a run array by array: beside what the libraries take themselves, no more memory than twice the file, and twice
// the picture that they write.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/normal.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

const std::string tool = std::string(GRAINCRACK_BIN) + "/graincrack-post";

/// Largest resident memory of a call of the tool, bytes; its exit code must be 0.
double memory_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), tool);
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char*> words;
        for (std::string& argument : arguments) words.push_back(argument.data());
        words.push_back(nullptr);
        if (std::freopen("/dev/null", "w", stdout) != nullptr) execv(tool.c_str(), words.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << arguments[1];
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// A run of 100,000 grains with two frames of numbers that do not compress, as those of the solver.
void write_large_run(const std::string& path) {
    test::Normal random(20140450);
    test::Recipe recipe;
    recipe.specimen = test::grid_specimen(224, 224, 0.08, 0.16);
    RunWriter writer(H5Output(path, "run"), recipe.specimen, test::synthetic_header(recipe));
    writer.append_history(test::synthetic_history(recipe));
    for (const double time : {1.0, 1.25}) {
        Frame frame = test::synthetic_frame(recipe.specimen, time, 0.005, 0);
        const auto shake = [&](auto& values, double scale) {
            for (auto& row : values) {
                for (double& value : row) value += scale * (random.uniform() - 0.5);
            }
        };
        shake(frame.displacement, 1e-6);
        shake(frame.velocity, 1);
        shake(frame.element_stress, 1e7);
        for (auto* jumps : {&frame.opening, &frame.sliding}) shake(*jumps, 1e-6);
        shake(frame.traction, 1e6);
        writer.add_frame(frame, FrameRole::kept);
    }
    Provenance provenance;
    provenance.tool = "synthetic";
    writer.finish(test::synthetic_header(recipe), test::synthetic_cracks(recipe.specimen), provenance);
}

TEST(Memory, IsAtMostTwiceTheFile) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
    GTEST_SKIP() << "a sanitized program takes a multiple of it";
#endif
#endif
    if (!std::filesystem::exists(tool)) GTEST_SKIP() << tool << " is not built";
    const test::TemporaryFolder folder;
    const std::string run = folder.file("run.h5");
    write_large_run(run);
    const auto size = static_cast<double>(std::filesystem::file_size(run));
    EXPECT_GT(size, 40e6);
    const double libraries = memory_of({"plot", "lennard-jones", "-o", folder.file("potential.svg")});  // with the fonts
    const std::vector<std::vector<std::string>> calls{{"strength", run},
                                                      {"moduli", run},
                                                      {"history", run},
                                                      {"info", run, "--check"},
                                                      {"cracks", run, "--quiet", "-o", folder.file("cracks")},
                                                      {"plot", "cracks", run, "-o", folder.file("cracks.svg")},
                                                      {"plot", "fragments", run, "-o", folder.file("fragments.svg")}};
    for (const auto& call : calls) {
        const double memory = memory_of(call) - libraries;
        // Cairo and its writer hold an SVG as text, once each, until it is whole.
        const std::string& output = call.back();
        const double picture = output.ends_with(".svg") ? static_cast<double>(std::filesystem::file_size(output)) : 0;
        EXPECT_LE(memory, 2 * size + 2 * picture) << call[0] << " " << call[1];
    }
}

}  // namespace
}  // namespace graincrack
