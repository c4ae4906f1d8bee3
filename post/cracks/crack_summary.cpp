#include "post/cracks/crack_summary.hpp"

#include <numeric>

#include "post/cracks/crack_counts.hpp"
#include "post/cracks/rosette.hpp"
#include "post/run/run_state.hpp"

namespace graincrack {

namespace {

const std::vector<std::string> first_columns{
    "file",          "at",     "time_s",  "axial_strain",  "tensile_cracks",       "shear_cracks",   "separated", "fragments",
    "single_grains", "events", "b_value", "b_value_error", "b_value_completeness", "b_value_events", "peak_kind"};

std::vector<std::string> all_columns() {
    std::vector<std::string> columns = first_columns;
    columns.insert(columns.end(), label_columns().begin(), label_columns().end());
    columns.insert(columns.end(), {"tensile_length_m", "tensile_share_within_30_deg", "facet_share_within_30_deg"});
    return columns;
}

std::vector<Cell> balance_cells(const CrackBalance& b) {
    return {count_cell(b.tensile), count_cell(b.shear), count_cell(b.separated)};
}

/// Length of the tensile cracks until a time, the share of it along the load, and that of all facets.
std::vector<Cell> direction_cells(const std::vector<Crack>& cracks, const Specimen& specimen, double time) {
    const Rosette rosette = crack_rosette(cracks_until(cracks, time), specimen);
    return {std::accumulate(rosette.tensile.begin(), rosette.tensile.end(), 0.0), cell(share_along_load(rosette.tensile)),
            cell(share_along_load(rosette.facet))};
}

std::vector<double> magnitudes_of(const std::vector<EmissionEvent>& events) {
    std::vector<double> magnitudes;
    for (const EmissionEvent& event : events) {
        if (event.moment > 0) magnitudes.push_back(event.magnitude());
    }
    return magnitudes;
}

}  // namespace

CrackBalance balance_cracks(const std::vector<Crack>& cracks, double time) {
    CrackBalance balance;
    for (const Crack& crack : cracks) {
        if (crack.time > time) continue;
        balance.add(crack);
        if (crack.separated.time <= time) balance.separated += 0.5;
    }
    return balance;
}

void write_crack_summary(std::ostream& out, const RunData& run, const std::optional<LoadCurve>& curve, const CrackRows& log,
                         const std::vector<EmissionEvent>& events, const Fragments& fragments, TableFormat format) {
    TableWriter table(out, all_columns(), format);
    const std::vector<Crack> cracks = labelled(log.all, log.label);
    const auto begin = [&](const char* at, std::size_t row_index) {
        const double time = run.history[HistoryColumn::time][row_index];
        std::vector<Cell> row{run.name, std::string(at), time, curve ? Cell(curve->axial_strain[row_index]) : Cell()};
        for (Cell& each : balance_cells(balance_cracks(cracks, time))) row.push_back(std::move(each));
        return row;
    };
    const Cell kind = curve ? Cell(peak_kind(run, *curve)) : Cell();
    const auto finish = [&](std::vector<Cell> row, std::size_t row_index) {
        row.resize(first_columns.size() - 1);
        row.push_back(kind);
        const double time = run.history[HistoryColumn::time][row_index];
        for (Cell& each : label_cells(log.all, run.header.crack_event, time)) row.push_back(std::move(each));
        for (Cell& each : direction_cells(cracks, log.specimen, time)) row.push_back(std::move(each));
        table.row(row);
    };
    if (curve) finish(begin("peak", curve->peak), curve->peak);
    const std::size_t last = run.history.size() - 1;
    std::vector<Cell> row = begin("end", last);
    row.emplace_back(static_cast<std::int64_t>(fragments.all.size()));
    row.emplace_back(static_cast<std::int64_t>(fragments.single_grains()));
    row.emplace_back(static_cast<std::int64_t>(events.size()));
    const std::vector<double> magnitudes = magnitudes_of(events);
    const auto fit = magnitudes.empty() ? std::nullopt : fit_gutenberg_richter(magnitudes, completeness_of(magnitudes));
    if (fit) {
        for (const double value : {fit->b, fit->error, fit->completeness}) row.emplace_back(value);
        row.emplace_back(static_cast<std::int64_t>(fit->events));
    }
    finish(std::move(row), last);
}

}  // namespace graincrack
