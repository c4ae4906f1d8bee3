// What a program offers, for other programs: its commands with their options, and its tables and datasets.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace graincrack {

/// Whether the option is --help or --help-all of the command.
bool is_help(const CLI::Option* option, const CLI::App* app);
/// The options of a command that help shows. \param all or, with those that are required, the usual ones, else all but the seldom
std::vector<const CLI::Option*> shown_options(const CLI::App* app, bool all);
/// The default that help shows of an option; "" if it has none.
std::string shown_default(const CLI::Option& option);

/// The commands of a tool, or of a command, and the options of each, in the form of share/doc/file-format.md.
nlohmann::ordered_json describe(const CLI::App& app);

}  // namespace graincrack
