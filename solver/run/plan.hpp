// Size and length of a run before it is started.
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/setup/request.hpp"

namespace graincrack {

struct SimulationPlan {
    std::size_t grains = 0, elements = 0, nodes = 0, contacts = 0;
    double stable_time_step = 0;  ///< s
    double time_step = 0;         ///< s
    std::int64_t max_steps = 0;   ///< to the strain limit, with the longest that stages may wait for rest
    std::size_t memory = 0;       ///< of the state and the assemblage, bytes
    std::size_t file_size = 0;    ///< at most, before compression, bytes
};

SimulationPlan plan_simulation(const Specimen& specimen, const SimulationRequest& request);

}  // namespace graincrack
