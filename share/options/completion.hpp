// Completion of command lines for shells, made from the options of a tool.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace graincrack {

/// A script that completes subcommands, options and the words that an option takes, and file names elsewhere.
/// \param tool as `describe` has it \param shell "bash" or "zsh" \throws UsageError for others
std::string completion_script(const nlohmann::ordered_json& tool, const std::string& shell);

}  // namespace graincrack
