// Options that several commands of graincrack-post share. Included by the option files only.
#pragma once

#include <string>
#include <vector>

#include "post/commands/commands.hpp"
#include "share/command_line.hpp"

namespace graincrack {

/// A command with its own examples; one that only holds others, `plot` and `ccd`, keeps those of the tool.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& help);
/// The files of a command, in place or by --files-from. \param name of the positional argument: "runs"
void add_files(CLI::App* command, PostOptions& options, const std::string& name, const std::string& help);
/// Reads the list of --files-from. \throws UsageError if a command that needs files has none
void complete_files(const CLI::App& command, PostOptions& options);
void add_format(CLI::App* command, PostOptions& options);
void add_output(CLI::App* command, PostOptions& options, const std::string& help);
void add_capped(CLI::App* command, PostOptions& options);
/// An option that may be given again.
void add_names(CLI::App* command, const std::string& option, std::vector<std::string>& target, const std::string& type,
               const std::string& help);
/// Options of everything that fits a model to the runs of a design.
void add_model(CLI::App* command, PostOptions& options);
void add_goals(CLI::App* command, PostOptions& options);
/// Options of a line or power law through columns of tables.
void add_trend(CLI::App* command, PostOptions& options);
void add_events(CLI::App* command, PostOptions& options);

}  // namespace graincrack
