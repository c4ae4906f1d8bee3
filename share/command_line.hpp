// What the command lines of the three tools have in common: quantities with units, configuration files, environment,
// --version, --print-config, --quiet, --verbose. Included by the mains and option files only; the rest never sees CLI11.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "share/progress.hpp"
#include "share/quantities.hpp"

namespace graincrack {

/// Options every tool has.
struct CommonOptions {
    Verbosity verbosity = Verbosity::normal;
    bool print_config = false;
    bool dry_run = false;
};

/// Adds an option for a quantity with a unit ("--edge 4mm"); its help names unit and bounds; GRAINCRACK_<NAME> is its
/// environment variable. `target` is SI.
CLI::Option* add_quantity(CLI::App& app, const std::string& option, double& target, const Quantity& quantity,
                          const std::string& help, const std::string& default_text = "");
/// The same for an optional quantity; unset if the option is not given.
CLI::Option* add_quantity(CLI::App& app, const std::string& option, std::optional<double>& target, const Quantity& quantity,
                          const std::string& help);

/// Sets up --help (with `examples` as footer), --version, --config, --print-config, --quiet, --verbose on an application.
void add_common_options(CLI::App& app, const std::string& tool, CommonOptions& options, const std::string& examples);

/// Parses; turns every complaint of CLI11 into one UsageError line (unknown configuration keys too). Returns false if the
/// call was answered already (--help, --version).
bool parse_command_line(CLI::App& app, int argc, char** argv);

/// The effective options as TOML that --config loads again.
std::string effective_configuration(const CLI::App& app);

/// Processors this process may use.
int available_processors();

}  // namespace graincrack
