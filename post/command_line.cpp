#include "post/command_line.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_version.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <list>
#include <sstream>

#include "post/chart/font.hpp"
#include "post/chart/picture.hpp"
#include "post/commands/commands.hpp"
#include "post/cracks/crack_map.hpp"
#include "post/table/documented_tables.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/file/output_file.hpp"
#include "share/options/command_line.hpp"

namespace graincrack {

namespace {

const char* const examples =
    "  graincrack-post strength uniaxial.h5 brazilian.h5\n"
    "  graincrack-post plot cracks uniaxial.h5 --frame peak -o cracks.png\n";

/// The commands in the order of --help.
std::vector<Command> commands() {
    // clang-format off
    return {
        info_command(),
        history_command(),
        strength_command(),
        moduli_command(),
        toughness_command(),
        envelope_command(),
        properties_command(),
        size_effect_command(),
        summarize_command(),
        material_command(),
        kind_command(),
        fpz_command(),
        ccd_command(),
        calibrate_command(),
        cracks_command(),
        classes_command(),
        export_command(),
        report_command(),
        view_command(),
        plot_command(),
    };
    // clang-format on
}

/// A command of the program, with the files that the command line gives it.
struct Registered {
    OptionSet options;
    std::string name;  ///< "strength", "plot curve"
    std::optional<FileArguments> arguments;
    std::vector<std::string> files;
    std::string files_from;
    Prints prints;
    std::optional<TableFormat> format;
    std::string output;  ///< of the table; "" for stdout
    Action action;
};
using Registry = std::list<Registered>;  // their files stay where the options write them

/// Adds a command, or a command and those it holds. \param prefix of its name: "plot " for those of `plot`
void add(OptionSet parent, const Command& command, const std::string& prefix, Registry& registry) {
    const std::string name = prefix + command.name;
    std::string lines;
    for (const std::string& example : command.examples) lines += fmt::format("  graincrack-post {} {}\n", name, example);
    const OptionSet set = parent.add_subcommand(command.name, command.help, lines);
    if (!command.subcommands.empty()) {
        for (const Command& sub : command.subcommands) add(set, sub, name + " ", registry);
        return;
    }
    Registered& own = registry.emplace_back(Registered{set, name, command.files, {}, {}, command.prints, {}, {}, {}});
    if (command.files) {
        add_files(set, command.files->name, own.files, std::string(command.files->help) + " (- is stdin)", command.files->several)
            .only_on_command_line();
        add_text(set.seldom(), "--files-from", own.files_from,
                 "file with a list of files, one per line or with a NUL behind each (- is stdin)")
            .type_name("FILE")
            .only_on_command_line();
    }
    own.action = command.add_options(set);
    if (command.prints == Prints::no_table) return;
    if (command.prints == Prints::table) add_format(set, own.format.emplace(TableFormat::tsv));
    if (command.prints == Prints::terminal_table) add_format(set, own.format);
    add_output_file(set, own.output, "file of the table, in place of stdout", {".tsv"});
}

/// Names of files, one a line, or each with a NUL behind it as of `find -print0`.
std::vector<std::string> read_list(const std::string& path) {
    const std::string list = path == "-" ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : text_of_file(path);
    std::vector<std::string> names;
    for (const std::string_view name : split(list, list.find('\0') == std::string::npos ? '\n' : '\0')) {
        if (!name.empty()) names.emplace_back(name);
    }
    if (names.empty()) throw InputError(fmt::format("--files-from {}: no names; one file per line is needed", path));
    return names;
}

/// The files of a call: those in place, then those of the list.
std::vector<std::string> files_of(const Registered& command) {
    std::vector<std::string> files = command.files;
    const bool stdin_is_file = std::find(files.begin(), files.end(), "-") != files.end();
    if (!command.files_from.empty()) {
        const std::vector<std::string> more = read_list(command.files_from);
        if (command.files_from == "-" && stdin_is_file) {
            throw UsageError("--files-from -: stdin holds the list and cannot be a file too");
        }
        files.insert(files.end(), more.begin(), more.end());
    }
    if (files.empty() && command.arguments && command.arguments->needed) {
        throw UsageError(fmt::format("{}: missing; {} needs a file, or --files-from", command.arguments->name, command.name));
    }
    if (std::count(files.begin(), files.end(), "-") > 1) {
        throw UsageError("-: stands for stdin, which holds one file; give it once");
    }
    return files;
}

/// Runs a command. A file of its table appears whole or not at all.
void run(const Registered& command, std::ostream& out, Verbosity verbosity) {
    const bool is_terminal = command.output.empty() && out.rdbuf() == std::cout.rdbuf() && ::isatty(STDOUT_FILENO) == 1;
    const TableFormat format = command.format.value_or(is_terminal ? TableFormat::aligned : TableFormat::tsv);
    std::ostringstream table;
    std::ostream& data = command.output.empty() ? out : table;
    command.action({command.name, files_of(command), data, verbosity, format});
    if (!command.output.empty()) write_whole_file(command.output, table.str());
}

}  // namespace

void run_command_line(int argc, const char* const* argv, std::ostream& out) {
    gsl_set_error_handler_off();  // what fails says so by its value or status; the handler would end the process
    CommonOptions common;
    CommandLine line("graincrack-post", "Evaluates runs: tables, VTK files, pictures and reports", common, examples,
                     {vtk_library_version(), cairo_library_version(), pango_library_version(), std::string("GSL ") + GSL_VERSION},
                     [] {
                         return WrittenRows{documented_tables(), {}};
                     });
    Registry registry;
    for (const Command& command : commands()) add(line.options(), command, "", registry);
    if (!line.parse(argc, argv)) return;
    run(*std::ranges::find_if(registry, [](const Registered& each) { return each.options.is_called(); }), out, common.verbosity);
    out.flush();
    if (!out) throw OutputError("stdout: could not be written whole");
}

}  // namespace graincrack
