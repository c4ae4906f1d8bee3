// Options of commands that evaluate a central composite design.
#pragma once

#include "post/ccd/tables.hpp"
#include "post/options/command.hpp"

namespace graincrack {

inline constexpr FileArguments design_table{"table", "table of the runs: x1, x2, … and the responses"};
/// --factor, --model, --alpha: how a model is fitted to the runs of a design.
void add_model(OptionSet set, ccd::ModelOptions& options);
/// --target, --maximise, --minimise: the goals for the responses.
void add_goals(OptionSet set, ccd::GoalOptions& options);

}  // namespace graincrack
