// The common parts of the three programs' command lines: quantities with units, configuration files, --version, --print-config,
// --events, --quiet, --verbose. option_set.hpp declares options.
//
// A program reads its command line as follows:
//
//     CommonOptions common;
//     CommandLine line("graincrack-solve", "Runs tests", common, "  graincrack-solve uniaxial specimen.h5 -o run.h5");
//     add_threads(line.options(), threads);  // for a tool that computes with several threads
//     OptionSet uniaxial = line.options().add_subcommand("uniaxial", "compression between platens");
//     add_quantity(uniaxial, "--max-strain", max_strain, quantity::max_strain, "…", "0.015");
//     if (!line.parse(argc, argv)) return 0;  // --help, --version and --print-config are answered
//
// Options of the program may follow a subcommand. Subcommands may share targets: options added by the functions here have the
// default of the subcommand that runs; other targets keep their initial values.
//
// A value comes from a flag, otherwise from the file of --config, otherwise it is the default. The file is TOML. Keys are the
// names of options without leading dashes and of positional arguments; values are those of the command line, as text, number,
// boolean or array:
//
//     quiet = true                   # a key at the top is an option of the tool or of the subcommand that runs
//     max-strain = 0.015
//     [triaxial]                     # keys of a section are options of that subcommand, and win over those at the top;
//     confining-pressure = "4MPa"    # sections of other subcommands are checked for their names only
//
// A key that is not an option is an error. A key is ignored if a flag gives the option, or one that excludes it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "share/base/progress.hpp"
#include "share/file/datasets.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

/// Options of every program.
struct CommonOptions {
    Verbosity verbosity = Verbosity::normal;
    bool print_config = false;  ///< answered by `CommandLine::parse`
    bool dry_run = false;       ///< set by `add_dry_run`
};

/// A table that a command prints, or writes as `file` into its folder.
struct TableRow {
    std::string command;  ///< "strength --summary"
    std::string file;
    std::vector<NamedValue> columns;
};
/// The tables and datasets that a program writes, for --describe.
struct WrittenRows {
    std::vector<TableRow> tables;
    std::vector<NamedValue> datasets;
};

/// The command line of a program.
class CommandLine {
public:
    /// Sets up --help and --help-all (with `examples` at their end), --version, --config, --print-config, --quiet, --verbose,
    /// --events.
    /// \param libraries versions of libraries that only this program uses, for --version: "CGAL 5.5.1"
    /// \param written returns the tables and datasets that it writes
    CommandLine(const std::string& tool, const std::string& description, CommonOptions& common, const std::string& examples,
                const std::vector<std::string>& libraries = {}, const std::function<WrittenRows()>& written = nullptr);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// The options of the program, to which subcommands are added.
    [[nodiscard]] OptionSet options() const { return OptionSet(app_.get()); }

    /// Parses the command line. It turns every error of CLI11, also for unknown configuration keys, into one UsageError line that
    /// names the option and, if the value came from elsewhere, its origin. \return false if the call is already answered (--help,
    /// --help-all, --version, --describe, --print-config, which needs no required options)
    /// \param complete called after all options are read; it may call `replace_default`
    bool parse(int argc, const char* const* argv, const std::function<void()>& complete = {});
    /// Replaces the shown default of an option of the subcommand that runs; the caller sets its target. \return true if the
    /// default applies: neither the option nor one that excludes it is given
    bool replace_default(const std::string& option, const std::string& text);

    /// The values of the options that affect results (`Option::of`), once their targets are set.
    [[nodiscard]] Settings settings() const;
    /// The options in use as TOML that --config reads. Options without a value are comments.
    [[nodiscard]] std::string effective_configuration() const;

private:
    std::unique_ptr<CLI::App> app_;
};

/// Processors that this process may use: its affinity, or the quota of its control group if that is smaller.
int available_processors();
/// Adds --threads; its default is the number of processors that this process may use.
Option add_threads(OptionSet set, int& threads);
/// Adds --dry-run; `help` says what is printed.
Option add_dry_run(OptionSet set, CommonOptions& common, const std::string& help);

}  // namespace graincrack
