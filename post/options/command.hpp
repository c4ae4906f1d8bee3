// A command of graincrack-post: name, help, examples, files, options, and what it does; and the options that many commands share.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "post/table/table.hpp"
#include "share/base/progress.hpp"
#include "share/options/option_set.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// One call of a command, apart from the options that only this command has.
struct Call {
    std::string command;             ///< "strength", "plot curve": for messages
    std::vector<std::string> files;  ///< "-" is stdin
    std::ostream& out;               ///< where data go
    Verbosity verbosity = Verbosity::normal;
    TableFormat format = TableFormat::tsv;  ///< of the table that it prints

    /// The file of a command that takes exactly one. \throws UsageError if there are several
    [[nodiscard]] const std::string& file() const;
    /// The stream of diagnostics: stderr, with --quiet none.
    [[nodiscard]] std::ostream& diagnostics() const;
};

/// The files of a command, given in place or by --files-from.
struct FileArguments {
    const char* name = "";  ///< of the positional argument, as help shows it
    const char* help = "";
    bool needed = true;    ///< at least one
    bool several = false;  ///< any number
};
inline constexpr FileArguments one_run{"run", "run file"};
inline constexpr FileArguments several_runs{"runs", "run files", true, true};

/// Whether a command prints a table: it then has --format and -o. Unless these are given, a table goes to stdout as TSV, a
/// terminal table to a terminal aligned.
enum class Prints { no_table, table, terminal_table };

/// The action of a command once the command line has been read. \throws UsageError, InputError, OutputError
using Action = std::function<void(const Call&)>;

struct Command {
    std::string name;
    std::string help;                    ///< one line
    std::vector<std::string> examples;   ///< arguments of two calls that run
    std::optional<FileArguments> files;  ///< empty: the command takes no files
    /// Adds the options to those of the command, behind its files. They live as long as the action that is returned.
    std::function<Action(OptionSet)> add_options;
    std::vector<Command> subcommands;  ///< of a command that only holds others, and has neither examples, files nor options
    Prints prints = Prints::no_table;
};

/// A command that keeps its options in an `Options` of its own: `add` declares them, `run` uses them.
template <class Options>
Command make_command(std::string name, std::string help, std::vector<std::string> examples, std::optional<FileArguments> files,
                     const std::function<void(OptionSet, Options&)>& add,
                     const std::function<void(const Options&, const Call&)>& run, Prints prints = Prints::no_table) {
    const auto prepare = [add, run](OptionSet set) -> Action {
        const auto options = std::make_shared<Options>();
        add(set, *options);
        return [options, run](const Call& call) { run(*options, call); };
    };
    return {std::move(name), std::move(help), std::move(examples), files, prepare, {}, prints};
}

/// A command that only holds others.
inline Command make_group(std::string name, std::string help, std::vector<Command> subcommands) {
    return {std::move(name), std::move(help), {}, std::nullopt, nullptr, std::move(subcommands), {}};
}

/// --format table|tsv|jsonl|markdown. \param format a `TableFormat`, or an optional one, which is empty unless it is given
template <class Format>
void add_format(OptionSet set, Format& format) {
    using enum TableFormat;
    add_choice<Format>(set, "--format", format, {{"table", aligned}, {"tsv", tsv}, {"jsonl", jsonl}, {"markdown", markdown}},
                       "form of the table: aligned columns, as terminal tables with units, tab-separated values with one header "
                       "line, JSON lines, or Markdown; default: table on a terminal where such tables are known, else tsv");
}
/// --all-columns
void add_columns(OptionSet set, ColumnChoice& columns);
/// -o, --output, which is required. \param help what is written \param endings as of `add_output_file`
Option add_output(OptionSet set, std::string& output, const std::string& help, const std::vector<std::string>& endings);
/// The material of an option; notes on its values go to the diagnostics of the call. \throws InputError as `read_material`
Material read_material_of(const Call& call, const std::string& name_or_file);
/// The same of a material that may lack keys.
IncompleteMaterial read_incomplete_material_of(const Call& call, const std::string& name_or_file);

}  // namespace graincrack
