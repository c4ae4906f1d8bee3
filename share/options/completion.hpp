// Completion of command lines for shells, made from the options of a tool.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace graincrack {

/// A script that completes subcommands, options and the words that an option takes, and file names elsewhere.
/// \param shell "bash" or "zsh" \throws UsageError for others
std::string completion_script(const CLI::App& app, const std::string& shell);

}  // namespace graincrack
