// Size and length of a run before it is started.
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/setup/request.hpp"

namespace graincrack {

/// Bytes of the arrays of a run file, before compression.
struct RunFileSize {
    std::size_t specimen = 0;
    std::size_t row = 0;  ///< of the history, and of the probes of a program
    std::size_t frame = 0;
    std::size_t crack = 0;        ///< a row of the crack log
    std::size_t saved_state = 0;  ///< with the node–edge contacts of the start; 0 unless it is asked for
    [[nodiscard]] std::size_t total(std::size_t rows, std::size_t frames, std::size_t cracks) const {
        return specimen + rows * row + frames * frame + cracks * crack + saved_state;
    }
};

struct SimulationPlan {
    std::size_t grains = 0, elements = 0, nodes = 0, contacts = 0;
    double mass_scaling_factor = 0;  ///< 0: none
    double stable_time_step = 0;     ///< s
    double time_step = 0;            ///< s
    std::int64_t max_steps = 0;      ///< to the strain limit, with the longest that stages may wait for rest
    /// Steps that tests of granite take at the automatic rate; 0 for other rates and programs, of which nobody knows.
    std::int64_t usual_steps = 0;
    std::size_t rows = 0;  ///< of the history in as many steps
    /// Arrays of the run when it has made as many steps and all contact points have failed, bytes. The program, its libraries and
    /// the buffers of HDF5 take some 25 MB more. So do node–edge contacts, which nobody foresees: of a crushed specimen some
    /// three candidate pairs of 100 bytes a node.
    std::size_t memory = 0;
    RunFileSize file;
    std::size_t file_size = 0;  ///< with all rows and frames, and all contact points in the crack log, before compression, bytes
};

/// \throws InputError as the run itself
SimulationPlan plan_simulation(const Specimen& specimen, const SimulationRequest& request);

}  // namespace graincrack
