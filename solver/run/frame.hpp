// The state of a moment as a frame of the run file.
#pragma once

#include "share/file/run_file.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// The state as a frame of the run file, in the specimen's own order. Each rank has what it owns of it.
Frame make_frame(const Assemblage& assemblage, const ContactLaws& laws, const State& state);
/// Brings a frame together on the first rank.
Frame whole_frame(const Assemblage& assemblage, Frame own);

}  // namespace graincrack
