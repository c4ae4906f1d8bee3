// Tests whose runs are made by several ranks of MPI: how they are started, and that they are the runs of one process.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include "tests/end_to_end/same_arrays.hpp"
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {

/// Starts the command behind it on ranks, also on more than there are processors, and as root in a container. Ranks that have not
/// ended after some seconds are killed.
inline std::string on_ranks(int n, int seconds = 100) {
    return "mpirun --allow-run-as-root --oversubscribe --quiet --bind-to none --mca mpi_yield_when_idle 1 "
           "--mca btl_vader_single_copy_mechanism none --timeout " +
           std::to_string(seconds) + " -n " + std::to_string(n) + " ";
}

/// Skips its tests, with the reason, where there is nothing to run them with.
class OnRanks : public testing::Test {
protected:
    void SetUp() override {
        static const std::string reason = why_not();
        if (!reason.empty()) GTEST_SKIP() << reason;
    }

private:
    static std::string why_not() {
        const Shell shell;
        if (shell.run("mpirun --version | grep 'Open MPI'").exit_code != 0) return "there is no mpirun of Open MPI";
        if (shell.run("graincrack-solve --version | grep -x 'MPI: yes'").exit_code != 0) {
            return "graincrack-solve was built without MPI";
        }
        return "";
    }
};

/// The lines that begin so; mpirun has lines of its own.
inline std::string lines_of(const std::string& prefix, const std::string& text) {
    std::istringstream lines(text);
    std::string found;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(prefix)) found += line + "\n";
    }
    return found;
}

inline std::string digest_of_run(const Shell& shell, const std::string& run) {
    return shell.must("graincrack-post info --digest " + run + " | cut -d' ' -f1");
}

/// The digest of the run that is expected; where it is not, the arrays that differ are named.
inline void expect_same_run(const Shell& shell, const std::string& run, const std::string& expected) {
    const std::string digest = digest_of_run(shell, expected);
    ASSERT_EQ(digest.size(), 65U) << expected;
    const std::string found = digest_of_run(shell, run);
    EXPECT_EQ(found, digest) << run << " is not " << expected;
    if (found == digest || found.size() != digest.size()) return;
    const H5Input differs(shell.file(run));
    const H5Input right(shell.file(expected));
    for (const char* group : {"/history", "/cracks", "/state"}) {
        if (right.has(group)) expect_same_arrays(differs, right, group);
    }
}

/// What a run that saved its state went through; digests of runs that went through nothing are easily equal.
struct Extent {
    std::size_t cracks = 0;                     ///< contact points that failed
    std::size_t active_node_edge_contacts = 0;  ///< at the end
    double friction = 0;                        ///< J
};
inline Extent extent_of(const Shell& shell, const std::string& run) {
    const H5Input file(shell.file(run));
    return {file.read<std::int32_t>("/cracks/contact").size(), file.read<double>("/state/active_pairs").size(),
            file.read<double>("/history/energy_friction").back()};
}

}  // namespace graincrack::test
