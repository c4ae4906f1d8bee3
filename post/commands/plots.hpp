// The command `plot`: which picture goes by which name.
#pragma once

#include "post/commands/commands.hpp"

namespace graincrack {

/// Draws what `options.picture` names and writes it to `options.output`.
/// \throws UsageError, InputError, OutputError
void write_plot(const PostOptions& options);

}  // namespace graincrack
