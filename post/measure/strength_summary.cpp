#include "post/measure/strength_summary.hpp"

#include <algorithm>

#include "post/measure/caveats.hpp"
#include "post/run/comparability.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"
#include "share/base/events.hpp"

namespace graincrack {

namespace {

StrengthGroup group_of(const std::vector<RunData>& runs, const ComparableGroup& like, StrengthKind kind) {
    StrengthGroup group;
    const RunData& first = runs[like.runs.front()];
    group.test = first.header.test;
    group.shape = distinct_shape(first);
    group.confining_pressure = first.header.confining_pressure;
    group.plane = first.header.plane;
    std::vector<double> strengths;
    for (const std::size_t i : like.runs) {
        const Strength strength = measure_strength(runs[i]);
        if (const auto stress = strength.reported(kind)) strengths.push_back(*stress);
        if (!strength.has_peak(kind)) ++group.without_peak;
    }
    group.strength = positive_sample(strengths);
    group.runs = like.runs;
    const std::string heat = first.header.heat_label();
    group.distinction = heat + (heat.empty() || like.distinction.empty() ? "" : ", ") + like.distinction;
    return group;
}

void add_ratios(std::vector<StrengthGroup>& groups, const std::vector<RunData>& runs) {
    for (StrengthGroup& group : groups) {
        const auto is_of_its_rock = [&](const StrengthGroup& disc) {
            return disc.is_brazilian() && differences(runs[disc.runs.front()], runs[group.runs.front()], of_the_test).empty();
        };
        const auto disc = std::ranges::find_if(groups, is_of_its_rock);
        if (group.is_brazilian() || std::ranges::count_if(groups, is_of_its_rock) != 1) continue;
        if (disc->strength.n > 0) group.ratio_to_brazilian = group.strength.mean.value / disc->strength.mean.value;
    }
}

}  // namespace

std::string StrengthGroup::name() const {
    return series_label(test, confining_pressure, shape) + (distinction.empty() ? "" : ", " + distinction);
}

std::vector<StrengthGroup> group_strengths(const std::vector<RunData>& runs, StrengthKind kind) {
    std::vector<StrengthGroup> groups;
    for (const ComparableGroup& like : comparable_groups(list_of(runs), {}, {SettingGroup::heat})) {
        groups.push_back(group_of(runs, like, kind));
    }
    add_ratios(groups, runs);
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
                                {"runs", none, [](const R& r) { return r.group.runs.size(); }},
                                {"runs_without_peak", none, [](const R& r) { return r.group.without_peak; }},
                                {"strength", megapascal, [](const R& r) { return r.group.strength.mean.value; }},
                                {"strength_deviation", megapascal, [](const R& r) { return r.group.strength.deviation; }},
                                {"strength_low", megapascal, [](const R& r) { return r.group.strength.mean.low; }},
                                {"strength_high", megapascal, [](const R& r) { return r.group.strength.mean.high; }},
                                {"ratio_to_brazilian", none, [](const R& r) { return r.group.ratio_to_brazilian; }},
                                {"plane", none, [](const R& r) { return name_of(r.group.plane); }},
                                {"mean_edge", millimetre, [](const R& r) { return r.mean_edge; }},
                                {"shape", none, [](const R& r) { return r.group.shape; }},
                                {"differs_in", none, [](const R& r) { return r.group.distinction; }}};
    return all;
}

const Columns<SummaryRow>& summary_terminal_columns() {
    using R = SummaryRow;
    using namespace unit;
    static const Columns<R> all{
        {"test", none, [](const R& r) { return series_label(r.group.test, r.group.confining_pressure, r.group.shape); }},
        {"plane", none, [](const R& r) { return name_of(r.group.plane); }},
        {"edge", millimetre, [](const R& r) { return r.mean_edge; }},
        {"runs", none, [](const R& r) { return r.group.runs.size(); }},
        {"did not fail", none, [](const R& r) { return r.group.without_peak; }},
        {"strength", megapascal, [](const R& r) { return r.group.strength.mean.value; }},
        {"s.d.", megapascal, [](const R& r) { return r.group.strength.deviation; }},
        {"95 % interval of the mean", megapascal,
         [](const R& r) { return interval_cell(r.group.strength.mean.low, r.group.strength.mean.high, megapascal); }},
        {"over Brazilian", none, [](const R& r) { return r.group.ratio_to_brazilian; }},
        {"of", none, [](const R& r) { return r.group.distinction; }}};
    return all;
}

}  // namespace

void write_strength_summary(std::ostream& out, const std::vector<std::string>& paths, TableFormat format,
                            std::ostream& diagnostics, StrengthKind kind) {
    CaveatCount doubts;
    std::vector<SummaryRow> rows;
    const std::vector<RunData> runs = read_doubted_runs(paths, doubts, "strength", diagnostics);
    for (StrengthGroup& group : group_strengths(runs, kind)) {
        double edges = 0;
        for (const std::size_t i : group.runs) edges += runs[i].specimen.mean_edge;
        const double mean_edge = edges / static_cast<double>(group.runs.size());
        rows.push_back({std::move(group), mean_edge});
    }
    write_table(out, summary_columns(), summary_terminal_columns(), rows, format);
    out.flush();
    if (!out) return;  // the command says so
    for (const std::string& line : doubts.lines()) warn(diagnostics, "strength", {line, "caveats"});
}

}  // namespace graincrack
