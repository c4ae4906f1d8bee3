#include "post/laboratory/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "post/calibrate/predicted.hpp"
#include "post/run/comparability.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

using calibrate::Target;
using OptionalValue = std::optional<double>;

std::string column_of(const Target& target) {
    const Property& property = target.property;
    if (property.name == "uniaxial" || property.name == "first_peak") {
        return fmt::format("s1_at_{:.7g}_MPa", target.confining_pressure * in_megapascals);
    }
    return property.quantity.dimension == Dimension::toughness ? property.column : property.row();
}

OptionalValue slope_of(const OptionalValue& angle) { return angle ? OptionalValue(mohr_coulomb_slope(*angle)) : std::nullopt; }

/// Nothing of a laboratory or a kind is beside what was heated. \param heat how, "at +300 K"
void leave_alone(ComparisonRow& row, const std::string& heat) {
    row.is_heated = true;
    row.column += ", " + heat;
    row.laboratory.target.value = NAN;
    row.laboratory.origin = PropertyOrigin::unknown;
    row.laboratory.scatter.reset();
    row.kind.reset();
    row.kind_specimen.clear();
}

std::size_t n_without_peak(const SeedGroup& group, StrengthKind kind) {
    return static_cast<std::size_t>(
        std::ranges::count_if(group.runs, [kind](const MeasuredRun* run) { return !run->strength.has_peak(kind); }));
}

std::string shape_of(const MeasuredRun& test) {
    return test.data.header.loading() == Loading::bending ? test.bend.method : distinct_shape(test.data);
}

/// The rows of a comparison as they are made.
class Rows {
public:
    Rows(const std::optional<Material>& material, const MaterialPrediction& prediction, StrengthKind kind)
        : material_(material), prediction_(prediction), kind_(kind) {}

    /// A row for each group that measures a property. \return whether there are any
    bool add(const LaboratoryProperty& property, const std::vector<SeedGroup>& groups) {
        const std::size_t before = rows_.size();
        for (const SeedGroup& group : groups) add(property, group);
        return rows_.size() > before;
    }
    void add_untested(const LaboratoryProperty& property) { (void)new_row(property); }
    void add(const FabricEnvelope& fit) {
        const EnvelopeTests& tests = fit.tests;
        const auto laboratory = [&](const char* key) { return material_ ? material_->laboratory_value(key) : std::nullopt; };
        const auto seeds = fit_seed_envelopes(tests);
        const Estimate& angle = fit.envelope.friction_angle;
        const Estimate slope{mohr_coulomb_slope(angle.value), slope_of(angle.low), slope_of(angle.high)};  // b rises with φ
        fitted(fit, "cohesion C", "cohesion", unit::megapascal, fit.envelope.cohesion, laboratory("cohesion"));
        if (seeds) rows_.back().deviation = seeds->cohesion.deviation;
        fitted(fit, "friction angle φ", "friction_angle", unit::degree, angle, laboratory("friction_angle"));
        if (seeds) rows_.back().deviation = seeds->friction_angle.deviation;
        fitted(fit, "", "slope_b", unit::none, slope, slope_of(laboratory("friction_angle")));
    }
    [[nodiscard]] std::vector<ComparisonRow> take() { return std::move(rows_); }

private:
    ComparisonRow& new_row(const LaboratoryProperty& property) {
        ComparisonRow& row = rows_.emplace_back(ComparisonRow{property});
        row.name = property.name();
        row.column = column_of(property.target);
        row.ours.value = NAN;
        row.kind = prediction_.of(property.target);
        row.kind_specimen = row.kind ? prediction_.specimen_of(property.target) : "";
        return row;
    }
    void add(const LaboratoryProperty& property, const SeedGroup& group) {
        const Target& target = property.target;
        const bool is_strength = target.property.value == &strength_of;
        const MeasuredRun& first = group.first();
        const auto sample = group.sample_of([&](const MeasuredRun& run) { return value_of(run, target, kind_); });
        if (!sample && !(is_strength && is_measured_by(target, first.data.header, shape_of(first)))) return;
        ComparisonRow& row = new_row(property);
        row.name = group.with_specimen(row.name);
        row.is_mean = true;
        if (is_strength) row.without_peak = n_without_peak(group, kind_);
        if (sample) {
            row.ours = sample->mean;
            row.deviation = sample->deviation;
            row.specimens = sample->n;
        }
        if (first.data.header.heat != 0) leave_alone(row, first.data.header.heat_label());
        if (!row.laboratory.is_measured() || !sample) return;
        row.caveat = target.caveat(first.bend);
        if (row.caveat.empty()) row.agreement = agreement_of(target, row.computed());
    }
    void fitted(const FabricEnvelope& fit, const std::string& name, const std::string& key, const ColumnUnit& unit,
                const Estimate& ours, const OptionalValue& laboratory) {
        ComparisonRow& row = rows_.emplace_back();
        Property& property = row.laboratory.target.property;
        property.key = key;
        property.unit = unit.name;
        property.si = 1 / unit.factor;
        row.laboratory.target.value = laboratory.value_or(NAN);
        row.laboratory.target.deviation = NAN;
        // The line follows from UCS and strengths under pressure.
        if (laboratory && !material_->fitted.empty()) {
            row.laboratory.origin = has_fitted_confined_strength(material_) ? PropertyOrigin::fitted : PropertyOrigin::predicted;
        }
        row.name = name + (name.empty() || fit.fabric.empty() ? "" : ", " + fit.fabric);
        row.column = property.row();
        row.ours = determined(ours).value_or(Estimate{NAN, {}, {}});
        row.specimens = fit.tests.compression.size();
        row.without_peak = fit.tests.at_strain_limit;
        if (fit.is_heated) leave_alone(row, fit.fabric);
    }

    const std::optional<Material>& material_;
    const MaterialPrediction& prediction_;
    StrengthKind kind_;
    std::vector<ComparisonRow> rows_;
};

std::vector<MeasuredRun> measured(const std::vector<RunData>& runs) {
    std::vector<MeasuredRun> all;
    for (const RunData& run : runs) {
        MeasuredRun& each = all.emplace_back();
        each.data = run;
        each.curve = load_curve(run);
        each.strength = measure_strength(run, each.curve);
        each.moduli = measure_moduli(run);
        if (is_compression(run.header)) each.thresholds = measure_all_thresholds(run, each.curve, {});
    }
    return all;
}

/// The line through the compression tests, if these are at several pressures.
std::vector<FabricEnvelope> envelopes_of(const std::vector<RunData>& runs, const std::vector<MeasuredRun>& tests,
                                         const EnvelopeOptions& options) {
    std::set<double> pressures;
    const std::string heat = runs.empty() ? "" : runs.front().header.heat_label();  // comparable runs have the same
    for (const MeasuredRun& test : tests) {
        if (!is_compression(test.data.header) || !test.strength.reported(options.strength)) continue;
        pressures.insert(test.data.header.confining_pressure);
    }
    if (pressures.size() < 2) return {};
    FabricEnvelope fit{heat, !heat.empty(), collect_envelope_tests(runs, options), {}};
    fit.envelope = fit_envelope(fit.tests.confining(), fit.tests.strength());
    return {std::move(fit)};
}

/// Those of the runs, and those at which the kind is asked for σ1.
std::set<double> pressures_of(const std::vector<RunData>& runs, const Material& material, const MaterialPrediction& prediction) {
    std::set<double> pressures;
    for (const RunData& run : runs) pressures.insert(run.header.confining_pressure);
    for (const auto& [name, predicted] : prediction.of_calibration) {
        pressures.insert(calibrate::target_of(name, "predicted").confining_pressure);
    }
    if (prediction.surface) {
        for (const LaboratoryProperty& each : laboratory_properties(material, {})) {
            pressures.insert(each.target.confining_pressure);
        }
        pressures.insert(material.laboratory_value("confining_pressure").value_or(0));
    }
    pressures.erase(0);
    return pressures.empty() ? std::set<double>{8e6, 20e6} : pressures;
}

}  // namespace

std::optional<Sample> SeedGroup::sample_of(const ValueOfTest& value) const {
    std::vector<double> values;
    for (const MeasuredRun* run : runs) {
        if (const auto own = value(*run)) values.push_back(*own);
    }
    return values.empty() ? std::nullopt : std::optional(positive_sample(values));
}

std::vector<SeedGroup> seed_groups(const std::vector<const MeasuredRun*>& all) {
    RunList runs;
    for (const MeasuredRun* run : all) runs.push_back(&run->data);
    std::vector<SeedGroup> groups;
    for (const ComparableGroup& like : comparable_groups(runs, {}, {SettingGroup::heat})) {
        const RunData& first = *runs[like.runs.front()];
        const std::string heat = first.header.heat_label();
        const std::string between = heat.empty() || like.distinction.empty() ? "" : ", ";
        SeedGroup& group = groups.emplace_back(SeedGroup{series_label(first), heat + between + like.distinction, {}, like.runs});
        for (const std::size_t i : like.runs) group.runs.push_back(all[i]);
    }
    return groups;
}

MaterialPrediction prediction_of(const Material& material) {
    MaterialPrediction prediction;
    prediction.surface = KindSurface::of(material, &prediction.why);
    if (!prediction.surface) return prediction;
    prediction.at = kind_coordinates(material);
    prediction.why = prediction.surface->beyond(prediction.at);
    if (!prediction.why.empty()) {
        prediction.surface.reset();
    } else {
        prediction.of_calibration = calibrate::predictions_in(material);
    }
    return prediction;
}

std::string MaterialPrediction::specimen_of(const Target& target) const {
    std::string specimen = KindSurface::specimen_of(target.property);
    if (of_calibration.empty() || of_calibration.contains(target.name())) return specimen;
    return specimen + (specimen.empty() ? "" : ", ") + "by the kind alone";
}

Estimate ComparisonRow::computed() const {
    return is_pooled() ? pooled_mean({specimens, ours, deviation}, *laboratory.scatter) : ours;
}

std::optional<double> ComparisonRow::off_laboratory_percent() const {
    const double known = laboratory.target.value;
    return laboratory.is_measured() && known != 0 ? OptionalValue(100 * (ours.value / known - 1)) : std::nullopt;
}

std::optional<double> ComparisonRow::half_interval_percent() const {
    const auto [value, low, high] = computed();
    if (!low || !high || value == 0) return std::nullopt;
    return std::abs(100 * (is_mean ? *high - value : (*high - *low) / 2) / value);
}

std::optional<double> ComparisonRow::specimens_for_3_percent() const {
    if (!is_mean || !deviation || ours.value == 0) return std::nullopt;
    constexpr double normal_95 = 1.96;
    return std::max(3.0, std::ceil(std::pow(normal_95 * *deviation / (0.03 * ours.value), 2)));
}

bool is_measured_by(const Target& target, const RunSettings& settings, const std::string& shape) {
    const bool is_known = target.measured_on && target.measured_on->is_known();
    const std::string usual = settings.loading() == Loading::bending ? "half-disc" : "";
    return settings.test == target.test() &&
           std::abs(settings.confining_pressure - target.confining_pressure) <= 1e-6 * target.confining_pressure &&
           shape == (is_known ? target.measured_on->method : usual);
}

std::optional<double> value_of(const MeasuredRun& test, const Target& target, StrengthKind kind) {
    if (!is_measured_by(target, test.data.header, shape_of(test))) return std::nullopt;
    return target.property.value == &strength_of ? test.strength.reported(kind) : target.property.value(test);
}

std::vector<ComparisonRow> compare(const std::vector<SeedGroup>& groups, const std::vector<FabricEnvelope>& envelopes,
                                   const std::vector<LaboratoryProperty>& properties, const std::optional<Material>& material,
                                   const MaterialPrediction& prediction, StrengthKind kind) {
    Rows rows(material, prediction, kind);
    std::vector<const LaboratoryProperty*> untested;
    auto envelope = envelopes.begin();
    for (const LaboratoryProperty& property : properties) {
        const bool is_behind_strengths = order_of(property.target.property) > order_of(property_named("first_peak"));
        for (; is_behind_strengths && envelope != envelopes.end(); ++envelope) rows.add(*envelope);
        if (!rows.add(property, groups)) untested.push_back(&property);
    }
    for (const LaboratoryProperty* property : untested) rows.add_untested(*property);
    return rows.take();
}

void require_material(const std::vector<RunData>& runs, IncompleteMaterial read) {
    take_laboratory(read);
    for (const RunData& run : runs) {
        const std::string found = read.missing.empty() ? difference_from(read.material, run.header) : "";
        if (found.empty()) continue;
        throw InputError(fmt::format("{}: is of another material than {}: they differ in {}; its own is needed", run.name,
                                     read.material.file.string(), found));
    }
}

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
    const auto pressures = pressures_of(runs, material, prediction);
    auto rows = compare(seed_groups(tests), envelopes_of(runs, tests, options),
                        laboratory_properties(material, {pressures.begin(), pressures.end()}, LaboratorySource::line), material,
                        prediction, options.strength);
    std::erase_if(rows, [](const ComparisonRow& row) { return !row.is_tested() && !row.kind; });
    return rows;
}

namespace {

Cell in_unit(const ComparisonRow& row, const OptionalValue& value) {
    return Cell(value).times(1 / row.laboratory.target.property.si);
}

OptionalValue of_specimen(const ComparisonRow& row, double deviations) {
    return row.kind ? OptionalValue(row.kind->specimen_at(deviations)) : std::nullopt;
}

/// A datasheet: the rows that laboratories know, each in its unit.
void write_datasheet(std::ostream& out, const std::vector<ComparisonRow>& rows) {
    TerminalTable table({"property", "unit", "ours", "95 % interval", "specimens", "did not fail", "laboratory", "by rock type",
                         "95 % of specimens", "which are"});
    for (const ComparisonRow& row : rows) {
        if (row.name.empty()) continue;
        const Property& property = row.laboratory.target.property;
        const ColumnUnit unit{property.unit, 1 / property.si};
        const auto [value, low, high] = row.computed();
        const auto least = of_specimen(row, -deviations_of_95_percent), most = of_specimen(row, deviations_of_95_percent);
        const bool all_failed = row.without_peak.value_or(0) == 0;
        table.row({row.name, unit.name.empty() ? " " : symbol_of(unit), in_unit(row, value), interval_cell(low, high, unit),
                   row.is_tested() ? Cell(row.specimens) : Cell(), all_failed ? Cell() : Cell(row.without_peak),
                   in_unit(row, row.laboratory.target.value), in_unit(row, of_specimen(row, 0)), interval_cell(least, most, unit),
                   row.kind_specimen});
    }
    table.write(out);
}

}  // namespace

void write_properties(std::ostream& out, const std::vector<ComparisonRow>& rows, TableFormat format) {
    using unit::none;
    using Row = ComparisonRow;
    if (format == TableFormat::aligned) return write_datasheet(out, rows);
    const auto of_kind = [](double deviations) {
        return [=](const Row& row) { return in_unit(row, of_specimen(row, deviations)); };
    };
    const Columns<Row> columns{{"property", none, [](const Row& row) { return row.column; }},
                               {"laboratory", none, [](const Row& row) { return in_unit(row, row.laboratory.target.value); }},
                               {"ours", none, [](const Row& row) { return in_unit(row, row.ours.value); }},
                               {"low", none, [](const Row& row) { return in_unit(row, row.computed().low); }},
                               {"high", none, [](const Row& row) { return in_unit(row, row.computed().high); }},
                               {"deviation", none, [](const Row& row) { return in_unit(row, row.deviation); }},
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
                               {"kind_95_high", none, of_kind(deviations_of_95_percent)},
                               {"kind_specimen", none, [](const Row& row) { return row.kind_specimen; }}};
    write_table(out, columns, rows, format);
}

}  // namespace graincrack
