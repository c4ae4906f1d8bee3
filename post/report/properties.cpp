#include "post/report/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "post/fit/paper_rock.hpp"
#include "post/measure/moduli.hpp"
#include "post/measure/strength_summary.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

constexpr double giga = 1e-9;

using OptionalValue = std::optional<double>;

OptionalValue scaled(const OptionalValue& value, double factor) { return value ? OptionalValue(*value * factor) : std::nullopt; }

Estimate scaled(const Estimate& e, double factor) { return {e.value * factor, scaled(e.low, factor), scaled(e.high, factor)}; }

/// What is known of the rock besides our specimens.
class Known {
public:
    explicit Known(const Material& material) : material_(material) {
        if (is_rock_of_paper(material.name)) paper_ = PaperModel{};
    }
    /// Of [laboratory], SI.
    [[nodiscard]] OptionalValue laboratory(const std::string& key) const {
        const auto found = material_.laboratory.find(key);
        return found == material_.laboratory.end() ? std::nullopt : OptionalValue(found->second);
    }
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
    [[nodiscard]] OptionalValue published(double PaperModel::*member) const {
        return paper_ ? OptionalValue((*paper_).*member) : std::nullopt;
    }

private:
    const Material& material_;
    std::optional<PaperModel> paper_;
};

void add_mean(std::vector<Property>& properties, Property property, const Sample& sample, double factor) {
    property.ours = scaled(sample.mean, factor);
    property.deviation = scaled(sample.deviation, factor);
    property.specimens = sample.n;
    property.is_mean = true;
    properties.push_back(std::move(property));
}

void add_moduli(std::vector<Property>& properties, const std::vector<RunData>& runs, const Known& known) {
    std::vector<double> young;
    std::vector<double> poisson;
    for (const RunData& run : runs) {
        if (run.header.test != "uniaxial") continue;
        if (const auto moduli = measure_moduli(run)) {
            young.push_back(moduli->chord.young_modulus);
            poisson.push_back(moduli->chord.poisson_ratio);
        }
    }
    if (young.empty()) return;
    add_mean(properties,
             {.name = "young_modulus_GPa",
              .laboratory = scaled(known.laboratory("young_modulus"), giga),
              .published = known.published(&PaperModel::young_modulus)},
             sample(young), giga);
    add_mean(properties,
             {.name = "poisson_ratio",
              .laboratory = known.laboratory("poisson_ratio"),
              .published = known.published(&PaperModel::poisson_ratio)},
             sample(poisson), 1);
}

/// In the order of group_strengths: Brazilian, tension, compression by rising pressure.
void add_strengths(std::vector<Property>& properties, const std::vector<RunData>& runs, const Known& known, StrengthKind kind) {
    for (const StrengthGroup& group : group_strengths(runs, kind)) {
        if (!group.shape.empty()) continue;  // neither a ring nor bending measures a property of the rock
        Property property;
        property.without_peak = group.without_peak;
        if (group.is_brazilian()) {
            property.name = "tensile_strength_MPa";
            property.laboratory = scaled(known.laboratory("tensile_strength"), in_megapascals);
            property.published = known.published(&PaperModel::tensile_strength);
        } else if (group.test == "tension") {
            property.name = "direct_tensile_strength_MPa";
        } else {
            property.name = fmt::format("s1_at_{:.7g}_MPa", group.confining_pressure * in_megapascals);
            property.laboratory = scaled(known.strength_at(group.confining_pressure), in_megapascals);
            if (group.confining_pressure == 0) property.published = known.published(&PaperModel::compressive_strength);
        }
        add_mean(properties, std::move(property), group.strength, in_megapascals);
    }
}

/// The slope b of an angle with its interval; b rises with φ.
Estimate slope_of(const Estimate& angle) {
    const auto slope = [](const OptionalValue& value) {
        return value ? OptionalValue(mohr_coulomb_slope(*value)) : std::nullopt;
    };
    return {mohr_coulomb_slope(angle.value), slope(angle.low), slope(angle.high)};
}

bool have_two_pressures(const std::vector<RunData>& runs) {
    std::set<double> pressures;
    for (const RunData& run : runs) {
        if (is_compression(run.header)) pressures.insert(run.header.confining_pressure);
    }
    return pressures.size() > 1;
}

void add_envelope(std::vector<Property>& properties, const EnvelopeTests& tests, const Known& known) {
    const Envelope envelope = fit_envelope(tests.confining(), tests.strength());
    const auto seeds = fit_seed_envelopes(tests);
    const auto add = [&](const std::string& name, const OptionalValue& laboratory, const OptionalValue& published,
                         const Estimate& ours) {
        properties.push_back({.name = name,
                              .laboratory = laboratory,
                              .published = published,
                              .ours = ours,
                              .specimens = tests.compression.size(),
                              .without_peak = tests.at_strain_limit});
    };
    const OptionalValue published_angle = known.published(&PaperModel::friction_angle);
    add("cohesion_MPa", scaled(known.laboratory("cohesion"), in_megapascals), known.published(&PaperModel::cohesion),
        scaled(envelope.cohesion, in_megapascals));
    if (seeds) properties.back().deviation = scaled(seeds->cohesion.deviation, in_megapascals);
    add("friction_angle_deg", scaled(known.laboratory("friction_angle"), in_degrees), published_angle,
        scaled(envelope.friction_angle, in_degrees));
    if (seeds) properties.back().deviation = scaled(seeds->friction_angle.deviation, in_degrees);
    add("slope_b", known.slope(),
        published_angle ? OptionalValue(mohr_coulomb_slope(*published_angle / in_degrees)) : std::nullopt,
        slope_of(envelope.friction_angle));
    const EnvelopeAt yield = fit_envelope_at_first_yield(tests);
    if (!yield.envelope) return;
    properties.push_back({.name = "cohesion_at_first_yield_MPa",
                          .ours = scaled(yield.envelope->cohesion, in_megapascals),
                          .specimens = yield.runs});
    properties.push_back({.name = "friction_angle_at_first_yield_deg",
                          .ours = scaled(yield.envelope->friction_angle, in_degrees),
                          .specimens = yield.runs});
}

}  // namespace

std::optional<double> Property::off_laboratory_percent() const {
    return laboratory && *laboratory != 0 ? OptionalValue(100 * (ours.value / *laboratory - 1)) : std::nullopt;
}

std::optional<double> Property::half_interval_percent() const {
    return ours.low && ours.high && ours.value != 0 ? OptionalValue(std::abs(50 * (*ours.high - *ours.low) / ours.value))
                                                    : std::nullopt;
}

std::optional<double> Property::specimens_for_3_percent() const {
    if (!is_mean || !deviation || ours.value == 0) return std::nullopt;
    constexpr double normal_95 = 1.96;
    return std::max(3.0, std::ceil(std::pow(normal_95 * *deviation / (0.03 * ours.value), 2)));
}

std::vector<Property> measure_properties(const std::vector<RunData>& runs, const Material& material,
                                         const EnvelopeOptions& options) {
    const Known known(material);
    std::vector<Property> properties;
    add_moduli(properties, runs, known);
    add_strengths(properties, runs, known, options.strength);
    if (have_two_pressures(runs)) add_envelope(properties, collect_envelope_tests(runs, options), known);
    return properties;
}

void write_properties(std::ostream& out, const std::vector<Property>& properties, TableFormat format) {
    using unit::none;
    using P = Property;
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
                                    {"specimens_for_3_percent", none, [](const P& p) {
                                         const auto needed = p.specimens_for_3_percent();
                                         return needed ? count_cell(*needed) : Cell();
                                     }}};
    write_table(out, columns, properties, format);
}

}  // namespace graincrack
