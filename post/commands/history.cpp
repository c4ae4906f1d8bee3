#include "post/commands/commands.hpp"

#include <algorithm>
#include <numbers>
#include <string_view>
#include <vector>

#include "post/measure/history.hpp"
#include "post/options/command.hpp"
#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/probe_file.hpp"
#include "share/file/schema.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

/// "strain_xx", "stress_xx_Pa": a column with its unit, angles in degrees.
std::string name_with_unit(const ProbeColumn& column, bool in_degrees) {
    const std::string_view unit = in_degrees && column.dimension == Dimension::angle ? "deg" : si_unit(column.dimension);
    return column.dimension == Dimension::one ? column.name : column.name + "_" + std::string(unit);
}

/// angle_deg and the columns of each point of a ring at the end of the run: a row a point.
void write_ring(std::ostream& out, const RunReader& run, const std::string& name, TableFormat format) {
    std::vector<ProbeHistory> points;
    const std::vector<std::string> names = probe_names(run.file());
    for (std::string point = point_of_ring(name, 0); std::binary_search(names.begin(), names.end(), point);) {
        points.push_back(read_probe(run.file(), point));
        point = point_of_ring(name, points.size());
    }
    std::vector<std::string> columns;
    for (const ProbeColumn& column : points.front().columns) columns.push_back(name_with_unit(column, true));
    TableWriter table(out, columns, format);
    for (const ProbeHistory& point : points) {
        if (point.columns.size() != columns.size() || point.values.front().empty()) {
            throw InputError(run.name() + ": probe " + point.name + " has not the columns or rows of its ring");
        }
        std::vector<Cell> row;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            row.emplace_back(point.values[c].back() *
                             (point.columns[c].dimension == Dimension::angle ? 180 / std::numbers::pi : 1));
        }
        table.row(row);
    }
}

/// time_s, step and every column of a probe, names with SI units. \throws InputError if the run has no such probe
void write_probe(std::ostream& out, const RunReader& run, const std::string& name, TableFormat format) {
    const std::vector<std::string> names = probe_names(run.file());
    if (std::binary_search(names.begin(), names.end(), point_of_ring(name, 0))) return write_ring(out, run, name, format);
    const ProbeHistory probe = read_probe(run.file(), name);
    const History history = run.history();
    std::vector<std::string> columns{"time_s", "step"};
    for (const ProbeColumn& column : probe.columns) columns.push_back(name_with_unit(column, false));
    for (const std::vector<double>& values : probe.values) {
        if (values.size() != history.size()) throw InputError(run.name() + ": probe " + name + " and history differ in length");
    }
    TableWriter table(out, columns, format);
    for (std::size_t i = 0; i < history.size(); ++i) {
        std::vector<Cell> row{history[HistoryColumn::time][i], count_cell(history[HistoryColumn::step][i])};
        for (const std::vector<double>& values : probe.values) row.emplace_back(values[i]);
        table.row(row);
    }
}

/// stage, begin_s, end_s, ended_by: a row a stage. \throws InputError for a run that does not record its stages, as all but those
/// of loading programs, or whose records differ in number
void write_stages(std::ostream& out, const RunReader& run, TableFormat format) {
    const std::string group = schema::program_group;
    if (!run.file().has(group)) {
        throw InputError(run.name() + ": stages are recorded only for runs of `graincrack-solve program`");
    }
    const auto names = run.file().attribute<std::vector<std::string>>(group, "stages");
    const auto ended_by = run.file().attribute<std::vector<std::string>>(group, "ended_by");
    const auto begin = run.file().read<double>(group + "/begin");
    const auto end = run.file().read<double>(group + "/end");
    if (names.size() != begin.size() || ended_by.size() != begin.size() || end.size() != begin.size()) {
        throw InputError(run.name() + ": names, times and ends of the stages differ in number");
    }
    TableWriter table(out, {"stage", "begin_s", "end_s", "ended_by"}, format);
    for (std::size_t i = 0; i < begin.size(); ++i) table.row({names[i], begin[i], end[i], ended_by[i]});
}

struct HistoryOptions {
    bool follow = false;
    std::string probe;    ///< of a loading program
    bool stages = false;  ///< of a loading program
};

void add_history_options(OptionSet set, HistoryOptions& options) {
    add_flag(set, "--follow", options.follow, "print the rows of a running test as they appear, until it ends");
    const Option probe =
        add_text(set, "--probe", options.probe,
                 "print the history of this probe or boundary of a loading program instead, of a ring a row an angle")
            .type_name("NAME");
    Option stages =
        add_flag(set, "--stages", options.stages, "print the stages of a loading program instead, and how each ended");
    stages.excludes(probe);
}

void show_history(const HistoryOptions& options, const Call& call) {
    if (options.follow && (options.stages || !options.probe.empty())) {
        throw UsageError("history --follow: follows the history alone; leave out --probe and --stages");
    }
    if (options.follow && call.format == TableFormat::aligned) {
        throw UsageError("history --follow: aligned columns are as wide as all rows need; --format tsv or jsonl fits");
    }
    const std::string& file = call.file();
    if (options.stages) return write_stages(call.out, RunReader(file), call.format);
    if (!options.probe.empty()) return write_probe(call.out, RunReader(file), options.probe, call.format);
    if (!options.follow) return write_history(call.out, RunReader(file), call.format);
    if (file == "-") throw UsageError("history --follow: stdin cannot be followed; name a file");
    follow_history(call.out, file, call.format);
}

}  // namespace

Command history_command() {
    return make_command<HistoryOptions>("history", "history of a run as a table, tension positive",
                                        {"uniaxial.h5", "uniaxial.h5 --follow --format jsonl"}, one_run, add_history_options,
                                        show_history, Prints::table);
}

}  // namespace graincrack
