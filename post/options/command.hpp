// What graincrack-post knows of each of its commands: name, help, examples, files, options, and what the command does.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "share/base/progress.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

/// One call of a command, apart from the options that only this command has.
struct Call {
    std::string command;             ///< "strength", "plot curve": for messages
    std::vector<std::string> files;  ///< "-" is stdin
    std::ostream& out;               ///< where data go
    Verbosity verbosity = Verbosity::normal;

    /// The file of a command that takes exactly one. \throws UsageError if there are several
    [[nodiscard]] const std::string& file() const;
    /// Where diagnostics go: stderr, with --quiet nowhere.
    [[nodiscard]] std::ostream& diagnostics() const;
};

/// The files of a command, given in place or by --files-from.
struct FileArguments {
    const char* name = "";  ///< of the positional argument, as help shows it
    const char* help = "";
    bool needed = true;  ///< at least one
};
inline constexpr FileArguments one_run{"run", "run file"};
inline constexpr FileArguments several_runs{"runs", "run files"};

/// What a command does once the command line has been read. \throws UsageError, InputError, OutputError
using Action = std::function<void(const Call&)>;

struct Command {
    std::string name;
    std::string help;                    ///< one line
    std::vector<std::string> examples;   ///< arguments of two calls that run
    std::optional<FileArguments> files;  ///< empty: the command takes no files
    /// Adds the options to those of the command, behind its files. They live as long as the action that is returned.
    std::function<Action(OptionSet)> add_options;
    std::vector<Command> subcommands;  ///< of a command that only holds others, and has neither examples, files nor options
};

/// A command that keeps its options in an `Options` of its own: `add` declares them, `run` uses them.
template <class Options>
Command make_command(std::string name, std::string help, std::vector<std::string> examples, std::optional<FileArguments> files,
                     const std::function<void(OptionSet, Options&)>& add,
                     const std::function<void(const Options&, const Call&)>& run) {
    const auto prepare = [add, run](OptionSet set) -> Action {
        const auto options = std::make_shared<Options>();
        add(set, *options);
        return [options, run](const Call& call) { run(*options, call); };
    };
    return {std::move(name), std::move(help), std::move(examples), files, prepare, {}};
}

/// A command that only holds others.
inline Command make_group(std::string name, std::string help, std::vector<Command> subcommands) {
    return {std::move(name), std::move(help), {}, std::nullopt, nullptr, std::move(subcommands)};
}

}  // namespace graincrack
