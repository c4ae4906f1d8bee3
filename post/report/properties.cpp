#include "post/report/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "post/fit/paper_rock.hpp"
#include "post/measure/property.hpp"
#include "post/measure/strength_summary.hpp"
#include "post/report/laboratory.hpp"
#include "post/run/comparability.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

using OptionalValue = std::optional<double>;

OptionalValue scaled(const OptionalValue& value, double factor) { return value ? OptionalValue(*value * factor) : std::nullopt; }

Estimate scaled(const Estimate& e, double factor) { return {e.value * factor, scaled(e.low, factor), scaled(e.high, factor)}; }

/// Values of the rock besides those of our specimens.
class Known {
public:
    explicit Known(const Material& material) : material_(material) {
        if (is_rock_of_paper(material.name)) paper_ = PaperModel{};
    }
    /// A value of [laboratory], SI.
    [[nodiscard]] OptionalValue laboratory(const std::string& key) const { return material_.laboratory_value(key); }
    /// b of the laboratory's line.
    [[nodiscard]] OptionalValue slope() const {
        const OptionalValue angle = laboratory("friction_angle");
        return angle ? OptionalValue(mohr_coulomb_slope(*angle)) : std::nullopt;
    }
    /// σ1 of the laboratory's line; without pressure the UCS that was measured.
    [[nodiscard]] OptionalValue strength_at(double pressure) const {
        if (pressure == 0) return laboratory("compressive_strength");
        const OptionalValue cohesion = laboratory("cohesion");
        const OptionalValue b = slope();
        if (!cohesion || !b) return std::nullopt;
        return 2 * *cohesion * std::sqrt(*b) + *b * pressure;
    }
    /// A value of the paper's model, by the keys of [laboratory], in the unit of the paper.
    [[nodiscard]] OptionalValue published(const std::string& key) const { return paper_ ? paper_->value(key) : std::nullopt; }

private:
    const Material& material_;
    std::optional<PaperModel> paper_;
};

constexpr Estimate unknown{NAN, std::nullopt, std::nullopt};

std::string name_of_strength(double confining_pressure) {
    return fmt::format("s1_at_{:.7g}_MPa", confining_pressure * in_megapascals);
}

/// The row of a property with the mean over specimens.
PropertyRow mean_row(const Property& property, const Sample& sample, const Known& known) {
    const double factor = 1 / property.si;
    return {.name = property.row(),
            .laboratory = scaled(known.laboratory(property.key), factor),
            .published = known.published(property.key),
            .ours = scaled(sample.mean, factor),
            .deviation = scaled(sample.deviation, factor),
            .specimens = sample.n,
            .is_mean = true};
}

void add_moduli(std::vector<PropertyRow>& properties, const std::vector<RunData>& runs, const Known& known) {
    std::vector<double> young;
    std::vector<double> poisson;
    for (const RunData& run : runs) {
        if (!run.header.is_unconfined_compression()) continue;
        if (const auto moduli = measure_moduli(run)) {
            young.push_back(moduli->chord.young_modulus);
            poisson.push_back(moduli->chord.poisson_ratio);
        }
    }
    if (young.empty()) return;
    properties.push_back(mean_row(property_named("young_modulus"), sample(young), known));
    properties.push_back(mean_row(property_named("poisson_ratio"), sample(poisson), known));
}

/// In the order of group_strengths: Brazilian, tension, compression by rising pressure.
void add_strengths(std::vector<PropertyRow>& properties, const std::vector<RunData>& runs, const Known& known,
                   StrengthKind kind) {
    for (const StrengthGroup& group : group_strengths(runs, kind)) {
        if (!group.shape.empty()) continue;  // neither a ring nor bending measures a property of the rock
        const Loading loading = test_named(group.test).loading;
        const char* const property = loading == Loading::splitting ? "brazilian"
                                     : loading == Loading::tension ? "direct_tension"
                                                                   : "uniaxial";
        PropertyRow& row = properties.emplace_back(mean_row(property_named(property), group.strength, known));
        row.without_peak = group.without_peak;
        if (loading == Loading::splitting || loading == Loading::tension) continue;
        row.name = name_of_strength(group.confining_pressure);
        row.confining_pressure = group.confining_pressure;
        row.laboratory = scaled(known.strength_at(group.confining_pressure), in_megapascals);
        if (group.confining_pressure > 0) row.published.reset();
    }
}

/// The slope b of an angle with its interval; b rises with φ.
Estimate slope_of(const Estimate& angle) {
    const auto slope = [](const OptionalValue& value) {
        return value ? OptionalValue(mohr_coulomb_slope(*value)) : std::nullopt;
    };
    return {mohr_coulomb_slope(angle.value), slope(angle.low), slope(angle.high)};
}

bool have_two_pressures(const std::vector<RunData>& runs, StrengthKind kind) {
    std::set<double> pressures;
    for (const RunData& run : runs) {
        if (is_compression(run.header) && measure_strength(run).reported(kind)) pressures.insert(run.header.confining_pressure);
    }
    return pressures.size() > 1;
}

void add_envelope(std::vector<PropertyRow>& properties, const EnvelopeTests& tests, const Known& known) {
    const Envelope envelope = fit_envelope(tests.confining(), tests.strength());
    const auto seeds = fit_seed_envelopes(tests);
    const auto add = [&](const std::string& name, const OptionalValue& laboratory, const OptionalValue& published,
                         const Estimate& ours) {
        properties.push_back({.name = name,
                              .laboratory = laboratory,
                              .published = published,
                              .ours = determined(ours).value_or(unknown),
                              .specimens = tests.compression.size(),
                              .without_peak = tests.at_strain_limit});
    };
    const OptionalValue published_angle = known.published("friction_angle");
    add("cohesion_MPa", scaled(known.laboratory("cohesion"), in_megapascals), known.published("cohesion"),
        scaled(envelope.cohesion, in_megapascals));
    if (seeds) properties.back().deviation = scaled(seeds->cohesion.deviation, in_megapascals);
    add("friction_angle_deg", scaled(known.laboratory("friction_angle"), in_degrees), published_angle,
        scaled(envelope.friction_angle, in_degrees));
    if (seeds) properties.back().deviation = scaled(seeds->friction_angle.deviation, in_degrees);
    add("slope_b", known.slope(),
        published_angle ? OptionalValue(mohr_coulomb_slope(*published_angle / in_degrees)) : std::nullopt,
        slope_of(envelope.friction_angle));
    const EnvelopeAt yield = fit_envelope_at_first_yield(tests);
    if (!yield.envelope || !yield.envelope->is_determined()) return;
    properties.push_back({.name = "cohesion_at_first_yield_MPa",
                          .ours = scaled(yield.envelope->cohesion, in_megapascals),
                          .specimens = yield.runs});
    properties.push_back({.name = "friction_angle_at_first_yield_deg",
                          .ours = scaled(yield.envelope->friction_angle, in_degrees),
                          .specimens = yield.runs});
}

}  // namespace

std::optional<double> PropertyRow::off_laboratory_percent() const {
    return laboratory && *laboratory != 0 ? OptionalValue(100 * (ours.value / *laboratory - 1)) : std::nullopt;
}

std::optional<double> PropertyRow::half_interval_percent() const {
    return ours.low && ours.high && ours.value != 0 ? OptionalValue(std::abs(50 * (*ours.high - *ours.low) / ours.value))
                                                    : std::nullopt;
}

std::optional<double> PropertyRow::specimens_for_3_percent() const {
    if (!is_mean || !deviation || ours.value == 0) return std::nullopt;
    constexpr double normal_95 = 1.96;
    return std::max(3.0, std::ceil(std::pow(normal_95 * *deviation / (0.03 * ours.value), 2)));
}

std::vector<PropertyRow> measure_properties(const std::vector<RunData>& runs, const Material& material,
                                            const EnvelopeOptions& options) {
    const Known known(material);
    std::vector<PropertyRow> properties;
    require_comparable(runs, "a property");
    add_moduli(properties, runs, known);
    add_strengths(properties, runs, known, options.strength);
    if (have_two_pressures(runs, options.strength)) add_envelope(properties, collect_envelope_tests(runs, options), known);
    return properties;
}

std::string add_predictions(std::vector<PropertyRow>& properties, IncompleteMaterial read) {
    take_laboratory(read);
    const Material& material = read.material;
    if (!read.missing.empty()) return fmt::format("its {} is not given", read.missing.front());
    std::string why;
    const auto surface = KindSurface::of(material, &why);
    if (surface) why = surface->beyond(kind_coordinates(material));
    if (!why.empty()) return why;
    const Known known(material);
    const auto add = [&](const Property& property, double pressure) {
        auto found = surface->predict(material, property, pressure);
        if (!found) return;
        const bool is_strength = property.name == "uniaxial" || property.name == "first_peak";
        const bool is_toughness = property.quantity.dimension == Dimension::toughness;
        const std::string name = is_strength ? name_of_strength(pressure) : is_toughness ? property.column : property.row();
        auto row = std::find_if(properties.begin(), properties.end(), [&](const PropertyRow& each) { return each.name == name; });
        if (row == properties.end()) {
            const OptionalValue laboratory = is_strength ? known.strength_at(pressure) : known.laboratory(property.key);
            row = properties.insert(
                row, {.name = name, .laboratory = scaled(laboratory, 1 / property.si), .ours = unknown, .specimens = 0});
        }
        found->value /= property.si;
        row->kind = found;
    };
    std::set<double> pressures;
    for (const PropertyRow& row : properties) pressures.insert(row.confining_pressure);
    for (const LaboratoryProperty& each : laboratory_properties(material, {})) pressures.insert(each.target.confining_pressure);
    pressures.insert(material.laboratory_value("confining_pressure").value_or(0));
    pressures.erase(0);
    if (pressures.empty()) pressures = {8e6, 20e6};
    for (const auto& [name, model] : surface->models()) {
        const Property& property = property_named(name);
        if (property.pressure != PressureOf::name) add(property, 0);
        if (property.pressure != PressureOf::name) continue;
        for (const double pressure : pressures) add(property, pressure);
    }
    return "";
}

void write_properties(std::ostream& out, const std::vector<PropertyRow>& properties, TableFormat format) {
    using unit::none;
    using P = PropertyRow;
    const auto of_kind = [](double deviations) {
        return [deviations](const P& p) { return p.kind ? OptionalValue(p.kind->specimen_at(deviations)) : std::nullopt; };
    };
    static const Columns<P> columns{{"property", none, [](const P& p) { return p.name; }},
                                    {"laboratory", none, [](const P& p) { return p.laboratory; }},
                                    {"published", none, [](const P& p) { return p.published; }},
                                    {"ours", none, [](const P& p) { return p.ours.value; }},
                                    {"low", none, [](const P& p) { return p.ours.low; }},
                                    {"high", none, [](const P& p) { return p.ours.high; }},
                                    {"deviation", none, [](const P& p) { return p.deviation; }},
                                    {"specimens", none, [](const P& p) { return p.specimens; }},
                                    {"without_peak", none, [](const P& p) { return p.without_peak; }},
                                    {"off_laboratory_percent", none, [](const P& p) { return p.off_laboratory_percent(); }},
                                    {"half_interval_percent", none, [](const P& p) { return p.half_interval_percent(); }},
                                    {"specimens_for_3_percent", none,
                                     [](const P& p) {
                                         const auto needed = p.specimens_for_3_percent();
                                         return needed ? count_cell(*needed) : Cell();
                                     }},
                                    {"kind_median", none, of_kind(0)},
                                    {"kind_50_low", none, of_kind(-deviations_of_50_percent)},
                                    {"kind_50_high", none, of_kind(deviations_of_50_percent)},
                                    {"kind_95_low", none, of_kind(-deviations_of_95_percent)},
                                    {"kind_95_high", none, of_kind(deviations_of_95_percent)}};
    write_table(out, columns, properties, format);
}

}  // namespace graincrack
