// Size and length of a run before it is started.
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/setup/request.hpp"
#include "solver/step/step_shares.hpp"

namespace graincrack {

struct SimulationPlan {
    std::size_t grains = 0, elements = 0, nodes = 0, contacts = 0;
    double mass_scaling_factor = 0;  ///< 0: none
    double stable_time_step = 0;     ///< s
    double time_step = 0;            ///< s
    std::int64_t max_steps = 0;      ///< to the strain limit, with the longest that stages may wait for rest
    /// Steps that tests of granite take at the automatic rate; 0 for other rates and programs, for which none are known.
    std::int64_t usual_steps = 0;
    StepBalance balance;   ///< before anything has failed
    double memory = 0;     ///< when all contact points have failed, bytes; this and the next by measured bytes a node
    double file_size = 0;  ///< with all frames, and all contact points in the crack log, before compression, bytes
};

/// \throws InputError as the run itself
SimulationPlan plan_simulation(const Specimen& specimen, const SimulationRequest& request);

}  // namespace graincrack
