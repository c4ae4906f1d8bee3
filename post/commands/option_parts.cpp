#include "post/commands/option_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

#include "post/commands/command_examples.hpp"

namespace graincrack {

namespace {

constexpr Quantity event_distance{"event_distance", Dimension::length, 0, 1e3, "distance within an acoustic event"};
constexpr Quantity event_time{"event_time", Dimension::time, 0, 1e6, "time within an acoustic event"};
constexpr Quantity significance{"alpha", Dimension::one, 0, 1, "level of significance", true};

/// Names of files, one a line.
std::vector<std::string> read_list(const std::string& path) {
    std::ifstream file;
    if (path != "-") {
        file.open(path);
        if (!file) throw InputError(fmt::format("--files-from {}: cannot be read: {}", path, std::strerror(errno)));
    }
    std::istream& stream = path == "-" ? std::cin : file;
    std::vector<std::string> names;
    for (std::string line; std::getline(stream, line);) {
        if (!line.empty()) names.push_back(line);
    }
    if (names.empty()) throw InputError(fmt::format("--files-from {}: no names; one file a line is needed", path));
    return names;
}

}  // namespace

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& help) {
    CLI::App* command = app.add_subcommand(name, help);
    const std::string whole = (app.get_parent() == nullptr ? "" : app.get_name() + " ") + name;
    command->footer("Examples:\n" + command_examples(whole));
    return command;
}

void add_files(CLI::App* command, PostOptions& options, const std::string& name, const std::string& help) {
    command->add_option(name, options.files, help + " (- is stdin)")->type_name("FILE")->configurable(false);
    command->add_option("--files-from", options.files_from, "list of files, one a line (- is stdin)")
        ->type_name("FILE")
        ->configurable(false);
}

void complete_files(const CLI::App& command, PostOptions& options) {
    if (!options.files_from.empty()) {
        const std::vector<std::string> more = read_list(options.files_from);
        if (options.files_from == "-" && std::find(options.files.begin(), options.files.end(), "-") != options.files.end()) {
            throw UsageError("--files-from -: stdin holds the list and cannot be a file too");
        }
        options.files.insert(options.files.end(), more.begin(), more.end());
    }
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_positional() || !options.files.empty() || command.get_name() == "law") continue;
        throw UsageError(fmt::format("{}: missing; {} {} needs a file, or --files-from", option->get_name(true), options.command,
                                     options.picture));
    }
}

void add_format(CLI::App* command, PostOptions& options) {
    add_choice<TableFormat>(*command, "--format", options.format, {{"tsv", TableFormat::tsv}, {"jsonl", TableFormat::jsonl}},
                            "form of the table: tab-separated with one header line, or JSON lines");
}

void add_output(CLI::App* command, PostOptions& options, const std::string& help) {
    command->add_option("-o,--output", options.output, help)->required();
}

void add_capped(CLI::App* command, PostOptions& options) {
    add_choice<CappedRuns>(*command, "--capped", options.capped_runs,
                           {{"refuse", CappedRuns::refuse}, {"accept", CappedRuns::accept}},
                           "runs that the strain cap ended: refuse them, or take their largest stress for a peak and say so");
}

void add_names(CLI::App* command, const std::string& option, std::vector<std::string>& target, const std::string& type,
               const std::string& help) {
    command->add_option(option, target, help)->type_name(type)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

/// Options of everything that fits a model to the runs of a design.
void add_model(CLI::App* command, PostOptions& options) {
    add_files(command, options, "table", "table of the runs: x1, x2, … and the responses");
    add_names(command, "--factor", options.ccd.factors, "NAME=LOW:HIGH",
              "factor with its values at -1 and +1, if the table has no x1");
    add_choice<bool>(*command, "--model", options.ccd.model.reduce, {{"full", false}, {"backward", true}},
                     "full quadratic, or reduced by backward elimination that keeps the hierarchy");
    add_quantity(*command, "--alpha", options.ccd.model.alpha, significance, "p above which elimination leaves a term out",
                 "0.1");
}

void add_goals(CLI::App* command, PostOptions& options) {
    add_names(command, "--target", options.ccd.targets, "NAME=[LOW:]TARGET[:HIGH]",
              "wanted value of a response; limits are the measured extremes unless given");
    add_names(command, "--maximise", options.ccd.maxima, "NAME=LOW:GOOD", "response as large as can be, useless at LOW");
    add_names(command, "--minimise", options.ccd.minima, "NAME=GOOD:HIGH", "response as small as can be, useless at HIGH");
}

void add_trend(CLI::App* command, PostOptions& options) {
    add_files(command, options, "tables", "tables: tab-separated with one header line; their rows are taken together");
    command->add_option("--x", options.trend.x, "column along x: a number a row")->required();
    command->add_option("--y", options.trend.y, "column along y: a number a row")->required();
    command->add_flag("--power", options.trend.power, "y = a x^b through logarithms in place of y = a + b x");
    add_names(command, "--group", options.trend.groups, "COLUMN",
              "a fit for each different entry of this column; may be given again");
}

void add_events(CLI::App* command, PostOptions& options) {
    add_quantity(*command, "--event-distance", options.crack_export.event_distance, event_distance,
                 "crack points so near are one acoustic event; two mean edges unless given");
    add_quantity(*command, "--event-time", options.crack_export.event_time, event_time,
                 "and so close in time; that distance at half the speed of shear waves unless given");
}

}  // namespace graincrack
