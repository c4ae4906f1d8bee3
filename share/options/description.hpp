// Describes a program for other programs: commands with their options, tables and datasets.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace graincrack {

/// True if the option is --help or --help-all of the command.
bool is_help(const CLI::Option* option, const CLI::App* app);
/// The options of a command in help. \param all true: all but the seldom ones; false: the usual and the required ones
std::vector<const CLI::Option*> shown_options(const CLI::App* app, bool all);
/// The default of an option in help; "" if it has none.
std::string shown_default(const CLI::Option& option);

/// The commands of a program or command, with the options of each, in the form of share/doc/file-format.md.
nlohmann::ordered_json describe(const CLI::App& app);

}  // namespace graincrack
