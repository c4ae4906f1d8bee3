#include "post/commands/program_table.hpp"

#include "share/error.hpp"
#include "share/h5_file.hpp"
#include "share/probe_file.hpp"
#include "share/schema.hpp"

namespace graincrack {

void write_probe(std::ostream& out, const RunReader& run, const std::string& name, TableFormat format) {
    const ProbeHistory probe = read_probe(run.file(), name);
    const History history = run.history();
    std::vector<std::string> columns{"time_s", "step"};
    for (const ProbeColumn& column : probe.columns) columns.push_back(column.name + "_" + std::string(si_unit(column.dimension)));
    for (const std::vector<double>& values : probe.values) {
        if (values.size() != history.size()) {
            throw InputError(run.name() + ": probe " + name + " and history differ in length");
        }
    }
    TableWriter table(out, columns, format);
    for (std::size_t i = 0; i < history.size(); ++i) {
        std::vector<Cell> row{history[HistoryColumn::time][i], count_cell(history[HistoryColumn::step][i])};
        for (const std::vector<double>& values : probe.values) row.emplace_back(values[i]);
        table.row(row);
    }
}

void write_stages(std::ostream& out, const RunReader& run, TableFormat format) {
    const std::string group = schema::program_group;
    if (!run.file().has(group)) throw InputError(run.name() + ": has no stages; a run of `graincrack-solve program` has");
    const auto names = run.file().attribute<std::vector<std::string>>(group, "stages");
    const auto ended_by = run.file().attribute<std::vector<std::string>>(group, "ended_by");
    const auto begin = run.file().read<double>(group + "/begin");
    const auto end = run.file().read<double>(group + "/end");
    TableWriter table(out, {"stage", "begin_s", "end_s", "ended_by"}, format);
    for (std::size_t i = 0; i < begin.size(); ++i) table.row({names[i], begin[i], end[i], ended_by[i]});
}

}  // namespace graincrack
