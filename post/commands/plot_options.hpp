// Options of the command `plot`.
#pragma once

#include "post/commands/commands.hpp"
#include "share/command_line.hpp"

namespace graincrack {

/// `plot` with all its pictures.
void add_plots(CLI::App& app, PostOptions& options);

}  // namespace graincrack
