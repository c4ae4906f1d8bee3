#include "post/measure/strength_summary.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "post/measure/caveats.hpp"
#include "post/measure/grain_size.hpp"
#include "post/measure/strength.hpp"
#include "post/run/comparable.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

struct Members {
    PlaneCondition plane{};
    std::vector<double> strengths;
    std::size_t without_peak = 0;
};

using SummaryKey = std::tuple<int, double, std::string, std::string>;  // order, confining pressure, test, shape

SummaryKey summary_key(const RunData& run) {
    const RunHeader& header = run.header;
    const int order = header.test == "brazilian" ? 0 : is_compression(header) ? 2 : 1;
    return {order, header.confining_pressure, header.test, distinct_shape(run)};
}

}  // namespace

std::vector<StrengthGroup> group_strengths(const std::vector<RunData>& runs, StrengthKind kind) {
    std::map<SummaryKey, Members> sets;
    require_same_settings(runs, "a mean over runs");
    for (const RunData& run : runs) {
        require_same_material(run, runs.front(), "a mean over runs");
        const Strength strength = measure_strength(run);
        Members& members = sets[summary_key(run)];
        members.plane = run.header.plane;  // the same in all, as settings are
        members.strengths.push_back(strength.reported(kind));
        if (!strength.has_peak(kind)) ++members.without_peak;
    }
    std::vector<StrengthGroup> groups;
    std::optional<double> brazilian;
    for (const auto& [key, members] : sets) {
        StrengthGroup group{std::get<2>(key),          std::get<3>(key),     std::get<1>(key), members.plane,
                            sample(members.strengths), members.without_peak, std::nullopt};
        if (group.is_brazilian()) {
            brazilian = group.strength.mean.value;
        } else if (brazilian) {
            group.ratio_to_brazilian = group.strength.mean.value / *brazilian;
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

namespace {

struct SummaryRow {
    StrengthGroup group;
    double mean_edge = 0;  ///< m
};

const Columns<SummaryRow>& summary_columns() {
    using R = SummaryRow;
    using namespace unit;
    static const Columns<R> all{{"test", none, [](const R& r) { return r.group.test; }},
                                {"confining_pressure", megapascal, [](const R& r) { return r.group.confining_pressure; }},
                                {"runs", none, [](const R& r) { return r.group.strength.n; }},
                                {"runs_without_peak", none, [](const R& r) { return r.group.without_peak; }},
                                {"strength", megapascal, [](const R& r) { return r.group.strength.mean.value; }},
                                {"strength_deviation", megapascal, [](const R& r) { return r.group.strength.deviation; }},
                                {"strength_low", megapascal, [](const R& r) { return r.group.strength.mean.low; }},
                                {"strength_high", megapascal, [](const R& r) { return r.group.strength.mean.high; }},
                                {"ratio_to_brazilian", none, [](const R& r) { return r.group.ratio_to_brazilian; }},
                                {"plane", none, [](const R& r) { return name_of(r.group.plane); }},
                                {"mean_edge", millimetre, [](const R& r) { return r.mean_edge; }},
                                {"shape", none, [](const R& r) { return r.group.shape; }}};
    return all;
}

const Columns<SummaryRow>& summary_terminal_columns() {
    using R = SummaryRow;
    using namespace unit;
    static const Columns<R> all{
        {"test", none, [](const R& r) { return series_label(r.group.test, r.group.confining_pressure, r.group.shape); }},
        {"plane", none, [](const R& r) { return name_of(r.group.plane); }},
        {"edge", millimetre, [](const R& r) { return r.mean_edge; }},
        {"runs", none, [](const R& r) { return r.group.strength.n; }},
        {"without peak", none, [](const R& r) { return r.group.without_peak; }},
        {"strength", megapascal, [](const R& r) { return r.group.strength.mean.value; }},
        {"s.d.", megapascal, [](const R& r) { return r.group.strength.deviation; }},
        {"95 % interval of the mean", megapascal,
         [](const R& r) { return interval_cell(r.group.strength.mean.low, r.group.strength.mean.high, megapascal); }},
        {"over Brazilian", none, [](const R& r) { return r.group.ratio_to_brazilian; }}};
    return all;
}

}  // namespace

void write_strength_summary(std::ostream& out, const std::vector<std::string>& paths, TableFormat format,
                            std::ostream& diagnostics, StrengthKind kind) {
    CaveatCount doubts;
    std::vector<SummaryRow> rows;
    const std::vector<RunData> runs = read_doubted_runs(paths, doubts);
    for (const SizedStrengths& sized : group_strengths_by_size(runs, kind)) {
        double edges = 0;
        for (const std::size_t i : sized.runs) edges += runs[i].specimen.mean_edge;
        rows.push_back({sized.group, edges / static_cast<double>(sized.runs.size())});
    }
    write_table(out, summary_columns(), summary_terminal_columns(), rows, format);
    out.flush();
    if (!out) return;  // the command says so
    for (const std::string& line : doubts.lines()) diagnostics << "strength: warning: " << line << '\n';
}

}  // namespace graincrack
