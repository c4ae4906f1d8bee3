#include "post/laboratory/properties.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "post/run/comparability.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

std::vector<MeasuredRun> measured(const std::vector<RunData>& runs) {
    std::vector<MeasuredRun> all;
    for (const RunData& run : runs) {
        MeasuredRun& each = all.emplace_back();
        each.data = run;
        each.curve = load_curve(run);
        each.strength = measure_strength(run, each.curve);
        each.moduli = measure_moduli(run);
    }
    return all;
}

/// The line through the compression tests, if these are at several pressures.
std::vector<FabricEnvelope> envelopes_of(const std::vector<RunData>& runs, const std::vector<MeasuredRun>& tests,
                                         const EnvelopeOptions& options) {
    std::set<double> pressures;
    bool is_heated = false;
    for (const MeasuredRun& test : tests) {
        is_heated = is_heated || test.data.header.heat != 0;
        if (!is_compression(test.data.header) || !test.strength.reported(options.strength)) continue;
        pressures.insert(test.data.header.confining_pressure);
    }
    if (pressures.size() < 2) return {};
    FabricEnvelope fit{"", is_heated, collect_envelope_tests(runs, options), {}};
    fit.envelope = fit_envelope(fit.tests.confining(), fit.tests.strength());
    return {std::move(fit)};
}

/// Those of the runs, and those at which the kind is asked for σ1.
std::set<double> pressures_of(const std::vector<RunData>& runs, const Material& material, bool has_kind) {
    std::set<double> pressures;
    for (const RunData& run : runs) pressures.insert(run.header.confining_pressure);
    if (has_kind) {
        for (const LaboratoryProperty& each : laboratory_properties(material, {})) {
            pressures.insert(each.target.confining_pressure);
        }
        pressures.insert(material.laboratory_value("confining_pressure").value_or(0));
    }
    pressures.erase(0);
    return pressures.empty() ? std::set<double>{8e6, 20e6} : pressures;
}

}  // namespace

std::vector<ComparisonRow> property_rows(const std::vector<RunData>& runs, IncompleteMaterial read,
                                         const EnvelopeOptions& options, std::string& why) {
    require_comparable(runs, "a property");
    take_laboratory(read);
    const Material& material = read.material;
    MaterialPrediction prediction;
    if (read.missing.empty()) {
        prediction = prediction_of(material);
    } else {
        prediction.why = fmt::format("its {} is not given", read.missing.front());
    }
    why = prediction.why;
    const std::vector<MeasuredRun> tests = measured(runs);
    const auto pressures = pressures_of(runs, material, prediction.surface.has_value());
    auto rows = compare(seed_groups(tests), envelopes_of(runs, tests, options),
                        laboratory_properties(material, {pressures.begin(), pressures.end()}, LaboratorySource::line), material,
                        prediction, options.strength);
    std::erase_if(rows, [](const ComparisonRow& row) { return !row.is_tested() && !row.kind; });
    return rows;
}

void write_properties(std::ostream& out, const std::vector<ComparisonRow>& rows, TableFormat format) {
    using unit::none;
    using Row = ComparisonRow;
    const auto in_unit = [](const Row& row, const std::optional<double>& value) {
        return Cell(value).times(1 / row.laboratory.target.property.si);
    };
    const auto of_kind = [in_unit](double deviations) {
        return [=](const Row& row) { return row.kind ? in_unit(row, row.kind->specimen_at(deviations)) : Cell(); };
    };
    const Columns<Row> columns{{"property", none, [](const Row& row) { return row.column; }},
                               {"laboratory", none, [=](const Row& row) { return in_unit(row, row.laboratory.target.value); }},
                               {"published", none, [=](const Row& row) { return in_unit(row, row.published); }},
                               {"ours", none, [=](const Row& row) { return in_unit(row, row.ours.value); }},
                               {"low", none, [=](const Row& row) { return in_unit(row, row.ours.low); }},
                               {"high", none, [=](const Row& row) { return in_unit(row, row.ours.high); }},
                               {"deviation", none, [=](const Row& row) { return in_unit(row, row.deviation); }},
                               {"specimens", none, [](const Row& row) { return row.specimens; }},
                               {"without_peak", none, [](const Row& row) { return row.without_peak; }},
                               {"off_laboratory_percent", none, [](const Row& row) { return row.off_laboratory_percent(); }},
                               {"half_interval_percent", none, [](const Row& row) { return row.half_interval_percent(); }},
                               {"specimens_for_3_percent", none,
                                [](const Row& row) {
                                    const auto needed = row.specimens_for_3_percent();
                                    return needed ? count_cell(*needed) : Cell();
                                }},
                               {"kind_median", none, of_kind(0)},
                               {"kind_50_low", none, of_kind(-deviations_of_50_percent)},
                               {"kind_50_high", none, of_kind(deviations_of_50_percent)},
                               {"kind_95_low", none, of_kind(-deviations_of_95_percent)},
                               {"kind_95_high", none, of_kind(deviations_of_95_percent)}};
    write_table(out, columns, rows, format);
}

}  // namespace graincrack
