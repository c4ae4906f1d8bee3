// Follows what damping carries of the load.
#pragma once

#include "solver/model/state.hpp"

namespace graincrack {

/// Wave transits over which motion and power are averaged.
inline constexpr double mean_transits = 4;

/// Takes the means on to the time of the state, after `measure`, by `state.damping_force` and the present displacements.
/// \param platen_power of both platens now, W \param time_constant of the means, s
void follow_damping_load(const Assemblage& assemblage, const State& state, double platen_power, double time_constant,
                         DampingLoad& load);

}  // namespace graincrack
