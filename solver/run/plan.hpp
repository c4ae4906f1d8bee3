// Estimates size and length of a run before it starts.
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/setup/request.hpp"
#include "solver/step/step_shares.hpp"

namespace graincrack {

struct SimulationPlan {
    std::size_t grains = 0, elements = 0, nodes = 0, contacts = 0;
    double mass_scaling_factor = 0;  ///< 0 for none
    double stable_time_step = 0;     ///< s
    double time_step = 0;            ///< s
    std::int64_t max_steps = 0;      ///< steps to the strain limit, with the longest time that stages may wait for rest
    /// Steps that tests of granite take at the automatic rate; 0 for other rates and programs, for which it is unknown.
    std::int64_t usual_steps = 0;
    StepBalance balance;   ///< balance before any failure
    double memory = 0;     ///< when all contact points have failed, bytes; like the next, by measured bytes per node
    double file_size = 0;  ///< with all frames, and all contact points in the crack log, before compression, bytes
};

/// Estimates a run. \throws InputError in the cases in which the run itself does
SimulationPlan plan_simulation(const Specimen& specimen, const SimulationRequest& request);

}  // namespace graincrack
