#include "post/measure/strength_summary.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "post/measure/caveats.hpp"
#include "post/measure/grain_size.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/terminal_tables.hpp"
#include "post/run/comparable.hpp"

namespace graincrack {

namespace {

struct Members {
    PlaneCondition plane{};
    std::vector<double> strengths;
    std::size_t without_peak = 0;
};

using Key = std::tuple<int, double, std::string>;  // order, confining pressure, test

Key key_of(const RunHeader& header) {
    const int order = header.test == "brazilian" ? 0 : is_compression(header) ? 2 : 1;
    return {order, header.confining_pressure, header.test};
}

}  // namespace

std::vector<StrengthGroup> group_strengths(const std::vector<RunData>& runs) {
    std::map<Key, Members> sets;
    require_same_settings(runs, "a mean over runs");
    for (const RunData& run : runs) {
        require_same_material(run, runs.front(), "a mean over runs");
        const Strength strength = measure_strength(run);
        Members& members = sets[key_of(run.header)];
        members.plane = run.header.plane;  // the same in all, as settings are
        members.strengths.push_back(strength.value());
        if (strength.peak_kind != "drop") ++members.without_peak;
    }
    std::vector<StrengthGroup> groups;
    std::optional<double> brazilian;
    for (const auto& [key, members] : sets) {
        StrengthGroup group{std::get<2>(key),          std::get<1>(key),     members.plane,
                            sample(members.strengths), members.without_peak, std::nullopt};
        if (group.test == "brazilian") {
            brazilian = group.strength.mean.value;
        } else if (brazilian) {
            group.ratio_to_brazilian = group.strength.mean.value / *brazilian;
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

void write_strength_summary(std::ostream& out, const std::vector<std::string>& paths, std::optional<TableFormat> format,
                            std::ostream& diagnostics) {
    static const std::vector<std::string> columns{"test",
                                                  "confining_pressure_MPa",
                                                  "runs",
                                                  "runs_without_peak",
                                                  "strength_MPa",
                                                  "strength_deviation_MPa",
                                                  "strength_low_MPa",
                                                  "strength_high_MPa",
                                                  "ratio_to_brazilian",
                                                  "plane",
                                                  "mean_edge_mm"};
    CaveatCount doubts;
    std::vector<std::vector<Cell>> rows;
    const auto megapascal = [](const std::optional<double>& stress) { return stress ? Cell(*stress * 1e-6) : Cell(); };
    const std::vector<RunData> runs = read_doubted_runs(paths, doubts);
    for (const SizedStrengths& row : group_strengths_by_size(runs)) {
        const StrengthGroup& g = row.group;
        double edges = 0;
        for (const std::size_t i : row.runs) edges += runs[i].specimen.mean_edge;
        rows.push_back({g.test, g.confining_pressure * 1e-6, static_cast<std::int64_t>(g.strength.n),
                        static_cast<std::int64_t>(g.without_peak), g.strength.mean.value * 1e-6, megapascal(g.strength.deviation),
                        megapascal(g.strength.mean.low), megapascal(g.strength.mean.high), cell(g.ratio_to_brazilian),
                        std::string(name_of(g.plane)), 1e3 * edges / static_cast<double>(row.runs.size())});
    }
    if (format) {
        TableWriter table(out, columns, *format);
        for (const auto& row : rows) table.row(row);
    } else {
        write_summary_to_terminal(out, {columns, rows});
    }
    out.flush();
    if (!out) return;  // the command says so
    for (const std::string& line : doubts.lines()) diagnostics << "strength: warning: " << line << '\n';
}

}  // namespace graincrack
