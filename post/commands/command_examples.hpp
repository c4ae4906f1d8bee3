// Two command lines that run, for the help of each command.
#pragma once

#include <string>

namespace graincrack {

/// A line each, indented. \param command "strength", "plot curve" \pre there is such a command
std::string command_examples(const std::string& command);

}  // namespace graincrack
