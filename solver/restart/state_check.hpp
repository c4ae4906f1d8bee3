// Whether a state that was read from a file is one that the solver can have left: a damaged one must not be computed with.
#pragma once

#include <string>

#include "solver/model/state.hpp"
#include "solver/setup/setup.hpp"

namespace graincrack {

/// Finds the groups of its pairs, and holds indices, lists and ranges of values of a state against one another and against the
/// assemblage. Sizes of the arrays that have one entry for each node, contact or chunk, and that all numbers are finite, must
/// have been checked before. \param name of the file, for messages \param time_step of the run that left it, s \throws InputError
/// naming what does not fit
void require_sound_state(const std::string& name, const Setup& setup, double time_step, State& state);

}  // namespace graincrack
