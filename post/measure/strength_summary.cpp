#include "post/measure/strength_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "post/measure/caveats.hpp"
#include "post/measure/strength.hpp"
#include "post/run/comparable.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

using SummaryKey = std::tuple<int, double, std::string, std::string>;  // order, confining pressure, test, shape

SummaryKey summary_key(const std::string& test, double confining_pressure, const std::string& shape) {
    const Loading loading = test_named(test).loading;
    const int order = loading == Loading::splitting ? 0 : loading == Loading::compression ? 2 : 1;
    return {order, confining_pressure, test, shape};
}

/// \throws InputError unless runs of one test differ in their seeds only, and all are of one material
void require_means(const std::vector<RunData>& runs) {
    require_same_settings(runs, "a mean over runs");
    for (const RunData& run : runs) require_same_material(run, runs.front(), "a mean over runs");
}

/// The groups of some runs, by their indices.
std::vector<StrengthGroup> groups_among(const std::vector<RunData>& runs, const std::vector<std::size_t>& indices,
                                        StrengthKind kind) {
    std::map<SummaryKey, std::vector<std::size_t>> sets;
    for (const std::size_t i : indices) {
        sets[summary_key(runs[i].header.test, runs[i].header.confining_pressure, distinct_shape(runs[i]))].push_back(i);
    }
    std::vector<StrengthGroup> groups;
    std::optional<double> brazilian;
    for (const auto& [key, members] : sets) {
        StrengthGroup group;
        std::tie(std::ignore, group.confining_pressure, group.test, group.shape) = key;
        group.plane = runs[members.front()].header.plane;  // the same in all, as settings are
        group.runs = members;
        std::vector<double> strengths;
        for (const std::size_t i : members) {
            const Strength strength = measure_strength(runs[i]);
            if (const auto stress = strength.reported(kind)) strengths.push_back(*stress);
            if (!strength.has_peak(kind)) ++group.without_peak;
        }
        group.strength = sample(strengths);
        if (group.is_brazilian()) {
            if (group.strength.n > 0) brazilian = group.strength.mean.value;
        } else if (brazilian) {
            group.ratio_to_brazilian = group.strength.mean.value / *brazilian;
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

}  // namespace

std::vector<GrainSize> grain_sizes(const std::vector<double>& edges) {
    constexpr double near = 1.05;
    std::vector<std::size_t> order(edges.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return edges[a] < edges[b]; });
    std::vector<GrainSize> sizes;
    for (const std::size_t i : order) {
        if (sizes.empty() || !(edges[i] < near * edges[sizes.back().runs.back()])) sizes.emplace_back();
        sizes.back().runs.push_back(i);
    }
    for (GrainSize& size : sizes) {
        double sum = 0;
        for (const std::size_t i : size.runs) sum += edges[i];
        size.label = fmt::format("edge {:.2g} mm", 1e3 * sum / static_cast<double>(size.runs.size()));
        std::sort(size.runs.begin(), size.runs.end());
    }
    return sizes;
}

std::vector<GrainSize> grain_sizes(const std::vector<RunData>& runs) {
    std::vector<double> edges;
    for (const RunData& run : runs) edges.push_back(run.specimen.mean_edge);
    return grain_sizes(edges);
}

std::string StrengthGroup::name() const {
    return series_label(test, confining_pressure, shape) + (size.empty() ? "" : ", " + size);
}

std::vector<StrengthGroup> group_strengths(const std::vector<RunData>& runs, StrengthKind kind) {
    require_means(runs);
    std::vector<std::size_t> all(runs.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return groups_among(runs, all, kind);
}

std::vector<StrengthGroup> group_strengths_by_size(const std::vector<RunData>& runs, StrengthKind kind) {
    require_means(runs);
    const std::vector<GrainSize> sizes = grain_sizes(runs);
    std::vector<StrengthGroup> groups;
    for (const GrainSize& size : sizes) {
        for (StrengthGroup& group : groups_among(runs, size.runs, kind)) {
            if (sizes.size() > 1) group.size = size.label;
            groups.push_back(std::move(group));
        }
    }
    std::stable_sort(groups.begin(), groups.end(), [](const StrengthGroup& a, const StrengthGroup& b) {
        return summary_key(a.test, a.confining_pressure, a.shape) < summary_key(b.test, b.confining_pressure, b.shape);
    });
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
        {"runs", none, [](const R& r) { return r.group.runs.size(); }},
        {"did not fail", none, [](const R& r) { return r.group.without_peak; }},
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
    for (StrengthGroup& group : group_strengths_by_size(runs, kind)) {
        double edges = 0;
        for (const std::size_t i : group.runs) edges += runs[i].specimen.mean_edge;
        const double mean_edge = edges / static_cast<double>(group.runs.size());
        rows.push_back({std::move(group), mean_edge});
    }
    write_table(out, summary_columns(), summary_terminal_columns(), rows, format);
    out.flush();
    if (!out) return;  // the command says so
    for (const std::string& line : doubts.lines()) diagnostics << "strength: warning: " << line << '\n';
}

}  // namespace graincrack
