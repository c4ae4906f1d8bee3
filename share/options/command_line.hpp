// What the command lines of the three tools have in common: quantities with units, configuration files,
// --version, --print-config, --events, --quiet, --verbose. Options are declared by option_set.hpp.
//
// A program reads its command line like this:
//
//     CommonOptions common;
//     CommandLine line("graincrack-solve", "Runs tests", common, "  graincrack-solve uniaxial specimen.h5 -o run.h5");
//     add_threads(line.options(), threads);  // for a tool that computes with several threads
//     OptionSet uniaxial = line.options().add_subcommand("uniaxial", "compression between platens");
//     add_quantity(uniaxial, "--max-strain", max_strain, quantity::max_strain, "…", "0.015");
//     if (!line.parse(argc, argv)) return 0;  // --help, --version and --print-config are answered
//
// Options of the tool may stand behind a subcommand.
// Subcommands may share targets: for options added by the functions here, the defaults of the subcommand that runs hold; other
// targets keep the values they were initialised with.
//
// A value comes from a flag, else from the file of --config, else it is the default. The file is TOML; keys are the names of
// options without dashes in front and of positional arguments, values are what would stand on the command line, as text, number,
// boolean or array:
//
//     quiet = true                   # a key at the top is an option of the tool or of the subcommand that runs
//     max-strain = 0.015
//     [triaxial]                     # keys of a section are options of that subcommand, and win over those at the top;
//     confining-pressure = "4MPa"    # sections of other subcommands are checked for their names only
//
// A key that is no option is an error. A key is ignored if a flag gave the option, or one that excludes it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "share/base/progress.hpp"
#include "share/file/datasets.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

/// Options every tool has.
struct CommonOptions {
    Verbosity verbosity = Verbosity::normal;
    bool print_config = false;  ///< answered by `CommandLine::parse`
    bool dry_run = false;       ///< set by `add_dry_run`
};

/// A table that a command prints, or writes into its folder as `file`.
struct TableRow {
    std::string command;  ///< "strength --summary"
    std::string file;
    std::vector<NamedValue> columns;
};
/// What a tool writes, for --describe.
struct WrittenRows {
    std::vector<TableRow> tables;
    std::vector<NamedValue> datasets;
};

/// The command line of a tool.
class CommandLine {
public:
    /// Sets up --help and --help-all (with `examples` at their end), --version, --config, --print-config, --quiet, --verbose,
    /// --events.
    /// \param libraries versions of the libraries of this tool alone, for --version: "CGAL 5.5.1"
    /// \param written what it writes
    CommandLine(const std::string& tool, const std::string& description, CommonOptions& common, const std::string& examples,
                const std::vector<std::string>& libraries = {}, const std::function<WrittenRows()>& written = nullptr);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// The options of the tool, which has its subcommands.
    [[nodiscard]] OptionSet options() const { return OptionSet(app_.get()); }

    /// Parses; turns every error that CLI11 finds into one UsageError line (also for unknown configuration keys) that names the
    /// option and, if the value was not on the command line, its origin. Returns false if the call was answered already (--help,
    /// --help-all, --version, --describe, --print-config, which needs no required options).
    /// \param complete called once all options are read; it may call `replace_default`
    bool parse(int argc, const char* const* argv, const std::function<void()>& complete = {});
    /// Shows another value as that which an option of the subcommand that runs has unless it is given; the caller sets its
    /// target. \return whether it holds: neither the option is given, nor one that excludes it
    bool replace_default(const std::string& option, const std::string& text);

    /// The effective values of the options that decide results (`Option::of`), once their targets are complete.
    [[nodiscard]] Settings settings() const;
    /// The effective options as TOML that --config loads again. Options without a value appear as comments.
    [[nodiscard]] std::string effective_configuration() const;

private:
    std::unique_ptr<CLI::App> app_;
};

/// Processors this process may use: its affinity, and the quota of its control group if that is less.
int available_processors();
/// Adds --threads, by default the processors this process may use.
Option add_threads(OptionSet set, int& threads);
/// Adds --dry-run; `help` says what is printed.
Option add_dry_run(OptionSet set, CommonOptions& common, const std::string& help);

}  // namespace graincrack
