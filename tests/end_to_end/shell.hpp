// Runs the tools as a user does: command lines of bash in a temporary folder.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/temporary_folder.hpp"

namespace graincrack::test {

/// Content of a file, "" if there is none.
inline std::string content_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_text(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

inline std::ptrdiff_t n_lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

/// Result of a command line.
struct Outcome {
    int exit_code = -1;
    std::string out;
    std::string err;
};

/// bash in an empty folder, with the tools on the PATH, an empty stdin and none of the caller's GRAINCRACK_ variables. The solver
/// has one thread unless --threads or --config is given: tests run side by side.
class Shell {
public:
    Shell() {
        std::string one_thread;
        for (const char* test : {"uniaxial", "triaxial", "brazilian", "tension", "bend", "program"}) {
            one_thread += std::string("[") + test + "]\nthreads = 1\n";
        }
        write_text(own_.file("one-thread.toml"), one_thread);
        write_text(own_.file("graincrack-solve"), "#!/bin/sh\ncase \" $* \" in *\" --config \"*) ;; *) set -- --config " +
                                                      own_.file("one-thread.toml") +
                                                      " \"$@\" ;; esac\nexec " GRAINCRACK_BIN "/graincrack-solve \"$@\"\n");
        std::filesystem::permissions(own_.file("graincrack-solve"), std::filesystem::perms::owner_all);
    }
    /// Runs lines of bash; a pipeline has the exit code of the last command in it that failed.
    [[nodiscard]] Outcome run(const std::string& lines) const {
        write_text(own_.file("lines.sh"), "unset \"${!GRAINCRACK_@}\"\nset -o pipefail\nexport LC_ALL=C PATH=" + own_.file("") +
                                              ":" GRAINCRACK_BIN ":$PATH\ncd " + folder_.file("") + "\n" + lines + "\n");
        const std::string command =
            "bash " + own_.file("lines.sh") + " </dev/null >" + own_.file("out") + " 2>" + own_.file("err");
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(own_.file("out")), content_of(own_.file("err"))};
    }
    /// Runs lines that must succeed; returns their stdout.
    std::string must(const std::string& lines) const {
        const Outcome outcome = run(lines);
        EXPECT_EQ(outcome.exit_code, 0) << lines << "\n" << outcome.err;
        return outcome.out;
    }
    /// Path of a file in the folder.
    [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }
    /// Names in the folder, a line each.
    [[nodiscard]] std::string names() const { return run("ls -A").out; }

private:
    TemporaryFolder folder_;
    TemporaryFolder own_;
};

}  // namespace graincrack::test
