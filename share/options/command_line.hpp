// What the command lines of the three tools have in common: quantities with units, configuration files, environment,
// --version, --print-config, --quiet, --verbose. Included by the files that declare options only; the rest never sees CLI11.
//
// A program reads its command line like this:
//
//     CLI::App app("Runs tests on specimens of grains");
//     CommonOptions common;
//     add_common_options(app, "graincrack-solve", common, "  graincrack-solve uniaxial specimen.h5 -o run.h5\n");
//     add_threads(app, threads);  // for a tool that computes with several threads
//     app.require_subcommand(1);
//     CLI::App* uniaxial = app.add_subcommand("uniaxial", "compression between platens");
//     add_quantity(*uniaxial, "--max-strain", max_strain, quantity::max_strain, "…", "0.015");
//     if (!parse_command_line(app, argc, argv)) return 0;  // --help, --version and --print-config are answered
//
// `add_common_options` comes first: what is added later inherits from it. Options of the tool may stand behind a subcommand.
// Subcommands may share targets: for options added by the functions here, environment and defaults of the subcommand that runs
// hold; other targets keep the values they were initialised with.
//
// Where a value comes from: a flag, else the environment variable GRAINCRACK_<OPTION> (--max-strain: GRAINCRACK_MAX_STRAIN),
// else the file of --config, else the default. The file is TOML; keys are the names of options without dashes in front and of
// positional arguments, values are what would stand on the command line, as text, number, boolean or array:
//
//     quiet = true                   # a key at the top is an option of the tool or of the subcommand that runs
//     max-strain = 0.015
//     [triaxial]                     # keys of a section are options of that subcommand, and win over those at the top;
//     confining-pressure = "4MPa"    # sections of other subcommands are checked for their names only
//
// A key that is no option is an error. A key is ignored if a flag or variable gave the option, or an option that excludes it.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "share/base/error.hpp"
#include "share/base/progress.hpp"
#include "share/base/quantities.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// Options every tool has.
struct CommonOptions {
    Verbosity verbosity = Verbosity::normal;
    bool print_config = false;  ///< answered by `parse_command_line`
    bool dry_run = false;       ///< set by `add_dry_run`
};

/// Adds an option for a quantity with a unit ("--edge 4mm"); its help names units and bounds. `target` is SI; if
/// `default_text` is not empty, the target is set from it and help shows it.
CLI::Option* add_quantity(CLI::App& app, const std::string& option, double& target, const Quantity& quantity,
                          const std::string& help, const std::string& default_text = "");
/// The same for an optional quantity; unset if the option is not given.
CLI::Option* add_quantity(CLI::App& app, const std::string& option, std::optional<double>& target, const Quantity& quantity,
                          const std::string& help);
/// The same where a keyword stands for a value: "--damping 0.8|none".
CLI::Option* add_quantity_or(CLI::App& app, const std::string& option, double& target, const Quantity& quantity,
                             const std::string& word, double word_value, const std::string& help,
                             const std::string& default_text = "");
/// Adds --fracture-energy mixed|mode-i|VALUE.
CLI::Option* add_fracture_energy(CLI::App& app, std::optional<FractureEnergyChoice>& target, const std::string& help);

/// Sets up --help (with `examples` as footer), --version, --config, --print-config, --quiet, --verbose on an application.
/// \param libraries versions of the libraries of this tool alone, for --version: "CGAL 5.5.1"
void add_common_options(CLI::App& app, const std::string& tool, CommonOptions& options, const std::string& examples,
                        const std::vector<std::string>& libraries = {});

/// Adds --threads, by default the processors this process may use.
CLI::Option* add_threads(CLI::App& app, int& threads);
/// Adds --dry-run; `help` says what is printed.
CLI::Option* add_dry_run(CLI::App& app, CommonOptions& options, const std::string& help);

/// Parses; turns every error that CLI11 finds into one UsageError line (also for unknown configuration keys) that names the
/// option and, if the value was not on the command line, its origin. Returns false if the call was answered already (--help,
/// --version, --print-config, which needs no required options).
/// \param complete called once all options are read and before defaults are; it may call `set_default`
bool parse_command_line(CLI::App& app, int argc, const char* const* argv, const std::function<void()>& complete = {});

/// Gives an option of the subcommand that runs another default, unless it is given, or one that excludes it.
void set_default(CLI::App& app, const std::string& option, const std::string& text);

/// The effective options as TOML that --config loads again. Options without a value appear as comments.
std::string effective_configuration(const CLI::App& app);

namespace detail {

/// "--edge" of "-e,--edge"; the name of a positional argument unchanged.
std::string long_name(const std::string& option);

/// An option with one value, read by `read`, whose exceptions pass through.
CLI::Option* add_value(CLI::App& app, const std::string& option, const std::function<void(const std::string&)>& read,
                       const std::string& help, const std::string& type_name, const std::string& default_text);

/// A whole number within bounds. \throws UsageError naming `where`
template <std::integral T>
T parse_integer(const std::string& text, const std::string& where, T lower, T upper) {
    T value{};
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end || value < lower || value > upper) {
        const bool open = upper == std::numeric_limits<T>::max();
        throw UsageError(
            where + ": \"" + text + "\" does not fit; it must be a whole number " +
            (open ? "of at least " + std::to_string(lower) : "from " + std::to_string(lower) + " to " + std::to_string(upper)));
    }
    return value;
}

}  // namespace detail

/// Adds an option for a whole number; help shows the value of `target` as the default.
template <std::integral T>
CLI::Option* add_integer(CLI::App& app, const std::string& option, T& target, const std::string& help, T lower,
                         T upper = std::numeric_limits<T>::max()) {
    const std::string where = detail::long_name(option);
    return detail::add_value(
        app, option,
        [&target, where, lower, upper](const std::string& text) { target = detail::parse_integer<T>(text, where, lower, upper); },
        help, "N", std::to_string(target));
}
/// The same for an optional number; unset if the option is not given.
template <std::integral T>
CLI::Option* add_integer(CLI::App& app, const std::string& option, std::optional<T>& target, const std::string& help, T lower,
                         T upper = std::numeric_limits<T>::max()) {
    const std::string where = detail::long_name(option);
    return detail::add_value(
        app, option,
        [&target, where, lower, upper](const std::string& text) { target = detail::parse_integer<T>(text, where, lower, upper); },
        help, "N", "");
}

/// Adds an option that takes one of several keywords; help shows the keyword of the value of `target` as the default.
template <class T>
CLI::Option* add_choice(CLI::App& app, const std::string& option, T& target,
                        const std::vector<std::pair<std::string, T>>& choices, const std::string& help) {
    std::string keywords;
    std::string default_keyword;
    for (const auto& [word, value] : choices) {
        keywords += (keywords.empty() ? "" : "|") + word;
        if (value == target) default_keyword = word;
    }
    const std::string where = detail::long_name(option);
    return detail::add_value(
        app, option,
        [&target, choices, keywords, where](const std::string& text) {
            for (const auto& [word, value] : choices) {
                if (word == text) {
                    target = value;
                    return;
                }
            }
            throw UsageError(where + ": unknown choice \"" + text + "\"; one of " + keywords + " fits");
        },
        help, keywords, default_keyword);
}
/// The same with the keyword itself as the value.
CLI::Option* add_choice(CLI::App& app, const std::string& option, std::string& target, const std::vector<std::string>& choices,
                        const std::string& help);

}  // namespace graincrack
