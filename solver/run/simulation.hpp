// A run from specimen to run file.
#pragma once

#include <optional>
#include <string>

#include "share/base/progress.hpp"
#include "share/file/provenance.hpp"
#include "share/file/run_file.hpp"
#include "solver/run/outcome.hpp"
#include "solver/setup/request.hpp"
#include "solver/step/step_shares.hpp"

namespace graincrack {

/// Work of the ranks of a run, and the messages between them.
struct RankSummary {
    int ranks = 1;
    double own_nodes = 0, ghost_nodes = 0, neighbours = 0;  ///< of the rank with most of each
    double bytes_a_step = 0, messages_a_step = 0;           ///< mean of the ranks
    double waited = 0;                                      ///< fraction of the time, mean of the ranks
    StepBalance balance;                                    ///< of the first rank at the end
    double threads_at_work = 1;                             ///< of the first rank, mean over time
};

/// The summary of a finished run for its user.
struct SimulationSummary {
    RunHeader header;
    std::optional<double> strength;  ///< axial stress, Pa, positive; in compression the first peak; empty if it did not fail
    double cracks_before = 0;        ///< micro-cracks before axial loading
    ModeCounts cracks;               ///< at the end, as tables count them; of the first rank
    double wall_time = 0;            ///< s
    double ns_per_grain_step = 0;
    std::vector<SensitivityRow> sensitivity;  ///< if asked for
    RankSummary ranks;
    std::string equilibrium_warning;      ///< "" for a test near equilibrium
    std::vector<std::string> overshoots;  ///< of stages of a program (`StageController`)
};

/// Runs the test and writes nothing. \param label what the progress says
/// \throws NumericalError, Interrupted
TestOutcome run_test(const Specimen& specimen, const SimulationRequest& request, const std::string& label, Verbosity verbosity);

/// Runs the test and writes the run file to `output` ("-": stdout).
/// \throws UsageError if something else has the name of the run or of its checkpoint, NumericalError if the run becomes unstable,
/// Interrupted on a signal, OutputError
SimulationSummary simulate(const Specimen& specimen, const SimulationRequest& request, const std::string& output,
                           Verbosity verbosity, Provenance provenance);

}  // namespace graincrack
