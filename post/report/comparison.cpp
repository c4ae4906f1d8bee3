#include "post/report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "post/kind/kind_surface.hpp"
#include "post/report/html.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace {

using calibrate::Target;
using html::number;

std::vector<double> tested_pressures(const std::vector<SeedGroup>& groups) {
    std::set<double> pressures;
    for (const SeedGroup& group : groups) {
        const RunHeader& header = group.first().data.header;
        if (header.description().is_confined) pressures.insert(header.confining_pressure);
    }
    return {pressures.begin(), pressures.end()};
}

/// Digits after the point that a value has with four significant digits.
int decimals_of(double value) {
    return value == 0 ? 0 : std::clamp(3 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 6);
}

std::string unit_text(const Target& target) { return target.property.unit.empty() ? "" : "\u00a0" + target.property.unit; }

std::string laboratory_cell(const LaboratoryProperty& property) {
    if (!property.is_measured()) return "";
    const double si = property.target.property.si;
    const char* const mark = property.has_own_deviation ? "" : "*";
    const auto& test = property.target.measured_on;
    return number(property.target.value / si) + " ± " + number(property.target.deviation / si, 2) + mark +
           unit_text(property.target) + (test ? "\n" + test->text() : "");
}

std::string difference_cell(const Target& target, double computed) {
    const double difference = computed - target.value;
    if (!target.property.absolute) return fmt::format("{:+.1f}\u00a0%", 100 * difference / target.value);
    return fmt::format("{:+.{}f}", difference / target.property.si, decimals_of(target.value / target.property.si));
}

/// The mean over runs with its interval; of one run that of the known scatter of specimens.
Estimate computed_of(const Sample& sample, const LaboratoryProperty& property) {
    Estimate computed = sample.mean;
    if (sample.n == 1 && property.half_interval_of_one) {
        computed.low = computed.value - *property.half_interval_of_one;
        computed.high = computed.value + *property.half_interval_of_one;
    }
    return computed;
}

/// "132.4 MPa\n125 to 140 (4 runs)"
std::string computed_cell(const Estimate& computed, std::size_t runs, const Target& target) {
    const double si = target.property.si;
    std::string text = number(computed.value / si) + unit_text(target) + "\n";
    if (computed.low) text += number(*computed.low / si) + " to " + number(*computed.high / si) + " ";
    return text + fmt::format("({}\u00a0run{}{})", runs, runs == 1 ? "" : "s",
                              computed.low && runs == 1 ? ", scatter of the calibration" : "");
}

/// The rows of the table, and what they count.
class ComparisonTable {
public:
    explicit ComparisonTable(const std::optional<Material>& material)
        : material_(material), surface_(material ? KindSurface::of(*material, &no_surface_) : std::nullopt) {
        if (surface_) no_surface_ = surface_->beyond(kind_coordinates(*material));
        if (!no_surface_.empty()) surface_.reset();
        table_ = html::Table(columns(material.has_value(), surface_.has_value()));
    }

    /// A row for each group that has the property; "not tested" for a value of the laboratory that no group has.
    void add(const LaboratoryProperty& property, const std::vector<SeedGroup>& groups) {
        const Target& target = property.target;
        // Its rule for tensile cracks is not that of the page.
        if (!property.is_measured() && !target.property.other.empty()) return;
        bool is_tested = false;
        for (const SeedGroup& group : groups) {
            const auto sample = group.sample_of([&](const TestReport& t) { return value_of(t, target); });
            if (!sample) continue;
            is_tested = true;
            const Estimate computed = computed_of(*sample, property);
            const std::string caveat = property.is_measured() ? target.caveat(group.first().bend) : "";
            const Agreement agreement =
                property.is_measured() && caveat.empty() ? agreement_of(target, computed) : Agreement::unknown;
            usual_deviation_ = usual_deviation_ || (property.is_measured() && !property.has_own_deviation);
            row({group.with_specimen(property.name()), laboratory_cell(property), computed_cell(computed, sample->n, target),
                 property.is_measured() ? difference_cell(target, computed.value) : "",
                 caveat.empty() ? verdict_of(agreement, sample->n) : caveat, name_of(property.origin), kind_cell(target)},
                agreement);
        }
        if (is_tested || !property.is_measured()) return;
        untested_.push_back({property.name(), laboratory_cell(property), "not tested"});
        if (surface_) untested_.back().insert(untested_.back().end(), {"", "", "", kind_cell(target)});
        usual_deviation_ = usual_deviation_ || !property.has_own_deviation;
    }
    /// A number of a fit through several tests. \param laboratory SI
    void add(const std::string& label, const Estimate& value, std::size_t tests, const std::optional<double>& laboratory,
             const ColumnUnit& unit, PropertyOrigin origin) {
        const std::string shown = "\u00a0" + std::string(unit.name == "deg" ? "°" : unit.name);
        const std::string known = laboratory ? number(*laboratory * unit.factor) + shown : "";
        if (!determined(value)) return row({label, known, not_determined(tests), "", "", "", ""}, Agreement::unknown);
        const std::string computed = number(value.value * unit.factor) + shown + "\n" + number(*value.low * unit.factor) +
                                     " to " + number(*value.high * unit.factor) + " (line)";
        row({label, known, computed, laboratory ? fmt::format("{:+.1f}\u00a0%", 100 * (value.value / *laboratory - 1)) : "", "",
             laboratory ? name_of(origin) : "", ""},
            Agreement::unknown);
    }
    [[nodiscard]] std::string str() const {
        html::Table whole = table_;
        for (const auto& cells : untested_) whole.row(cells, "untested");
        return summary() + whole.str() + explanation();
    }

private:
    static std::vector<std::string> columns(bool with_laboratory, bool with_kind) {
        const std::string computed = "computed: mean,\n95\u00a0% interval";
        if (!with_laboratory) return {"property", computed};
        std::vector<std::string> all{"property",   "laboratory\n± deviation", computed,
                                     "difference", "within or outside",       "fitted or predicted"};
        if (with_kind) all.emplace_back("a specimen, by the kind:\nmedian, 95\u00a0%");
        return all;
    }
    /// What the surface of the kind says of a new specimen; "" if nothing.
    [[nodiscard]] std::string kind_cell(const Target& target) const {
        const auto found = surface_ ? surface_->predict(*material_, target.property, target.confining_pressure) : std::nullopt;
        if (!found) return "";
        const auto at = [&](double deviations) { return number(found->specimen_at(deviations) / target.property.si); };
        return at(0) + unit_text(target) + "\n" + at(-deviations_of_95_percent) + " to " + at(deviations_of_95_percent);
    }
    /// \param cells with that of the kind at the end
    void row(std::vector<std::string> cells, Agreement agreement) {
        if (!surface_) cells.pop_back();
        if (!material_) cells = {cells[0], cells[2]};
        table_.row(std::move(cells), name_of(agreement));
        ++counts_[agreement];
    }
    /// How many properties agree, as one sentence.
    [[nodiscard]] std::string summary() const {
        const auto count = [&](Agreement agreement) {
            const auto found = counts_.find(agreement);
            return found == counts_.end() ? std::size_t{0} : found->second;
        };
        std::string counts;
        for (const Agreement agreement : {Agreement::within, Agreement::outside, Agreement::undecided}) {
            if (count(agreement) == 0) continue;
            counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count(agreement),
                                  agreement == Agreement::undecided ? "not decided" : name_of(agreement));
        }
        return counts.empty() ? ""
                              : html::paragraph("Beside the laboratory's values and their deviations: " + counts + ".", "lead");
    }
    /// What the column of the kind holds, or why there is none.
    [[nodiscard]] std::string of_kind() const {
        if (!no_surface_.empty()) return html::paragraph("The kind predicts nothing of this material: " + no_surface_ + ".");
        if (!surface_) return "";
        return html::paragraph(
            fmt::format("A specimen, by the kind: what a new specimen has by the surface of {} (graincrack-post kind), without "
                        "a run of this material; K_IC is that of a half-disc of 20 crystals' diameter.",
                        surface_->kind()));
    }
    [[nodiscard]] std::string explanation() const {
        std::string text = of_kind();
        if (counts_.count(Agreement::undecided) > 0) {
            text += html::paragraph(
                "Within, outside: so is the whole 95 % interval of the mean. Not decided: a part of it is, or there is none, as "
                "of "
                "one run of a material that does not tell its scatter; more seeds decide.");
        }
        if (usual_deviation_) {
            text += html::paragraph("* The material gives no deviation of this value: the usual one of such a measurement.");
        }
        return text;
    }
    const std::optional<Material>& material_;
    std::string no_surface_;  ///< why
    std::optional<KindSurface> surface_;
    html::Table table_{{}};
    std::vector<std::vector<std::string>> untested_;
    std::map<Agreement, std::size_t> counts_;
    bool usual_deviation_ = false;
};

void add_envelope_rows(ComparisonTable& table, const std::vector<SizedEnvelope>& envelopes,
                       const std::optional<Material>& material) {
    const auto laboratory = [&](const std::string& key) -> std::optional<double> {
        return material ? material->laboratory_value(key) : std::nullopt;
    };
    // The line follows from UCS and strengths under pressure.
    const PropertyOrigin origin = !material || material->fitted.empty()    ? PropertyOrigin::unknown
                                  : has_fitted_confined_strength(material) ? PropertyOrigin::fitted
                                                                           : PropertyOrigin::predicted;
    for (const SizedEnvelope& each : envelopes) {
        const std::string size = each.size.empty() ? "" : ", " + each.size;
        const std::size_t tests = each.tests.compression.size();
        table.add("cohesion C" + size, each.envelope.cohesion, tests, laboratory("cohesion"), unit::megapascal, origin);
        table.add("friction angle φ" + size, each.envelope.friction_angle, tests, laboratory("friction_angle"), unit::degree,
                  origin);
    }
}

/// Elastic constants and strengths, of which the last is the one under pressure.
bool stands_before_envelope(const LaboratoryProperty& property) {
    return order_of(property.target.property) <= order_of(property_named("first_peak"));
}

/// Crack initiation and damage of uniaxial tests by other definitions than the default. Definitions whose values are equal to
/// three digits share a row.
std::string other_thresholds(const std::vector<SeedGroup>& groups) {
    std::vector<std::pair<std::string, std::string>> rows;  // names, value
    for (const SeedGroup& group : groups) {
        if (!group.first().data.header.is_unconfined_compression()) continue;
        const std::size_t first = rows.size();
        for (const ThresholdDefinition& definition : other_threshold_definitions()) {
            const auto sample = group.sample_of([&](const TestReport& t) { return t.threshold(definition.stress); });
            if (!sample) continue;
            std::string value = number(sample->mean.value * in_megapascals, 3);
            if (sample->mean.low) {
                value += fmt::format(" ({} to {})", number(*sample->mean.low * in_megapascals, 3),
                                     number(*sample->mean.high * in_megapascals, 3));
            }
            const auto same = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end(),
                                           [&](const auto& row) { return row.second == value; });
            if (same == rows.end()) {
                rows.emplace_back(group.with_specimen(definition.name()), value);
            } else {
                same->first += "\n" + definition.name();
            }
        }
    }
    if (rows.empty()) return "";
    html::Table table({"definition", "stress, MPa (95\u00a0% interval)"});
    for (const auto& [name, value] : rows) table.row({name, value});
    return html::details("Other definitions of crack initiation and damage", table.str());
}

}  // namespace

std::optional<double> value_of(const MeasuredRun& test, const Target& target) {
    const RunHeader& header = test.data.header;
    const bool is_asked = header.test == target.test() &&
                          std::abs(header.confining_pressure - target.confining_pressure) <= 1e-6 * target.confining_pressure;
    const bool is_known = target.measured_on && target.measured_on->is_known();
    const std::string shape = header.loading() == Loading::bending ? test.bend.method : distinct_shape(test.data);
    const std::string usual = header.loading() == Loading::bending ? "half-disc" : "";
    if (!is_asked || shape != (is_known ? target.measured_on->method : usual)) return std::nullopt;
    return target.property.value(test);
}

std::string name_of(Agreement agreement) { return name_in({"", "within", "outside", "undecided"}, agreement); }

std::string verdict_of(Agreement agreement, std::size_t runs) {
    if (agreement != Agreement::undecided) return name_of(agreement);
    return runs == 1 ? "not decided by one run" : fmt::format("not decided ({} runs)", runs);
}

Agreement agreement_of(const Target& target, const Estimate& computed) {
    const double off = std::abs(computed.value - target.value);
    if (!std::isfinite(off) || !std::isfinite(target.deviation)) return Agreement::unknown;
    if (!computed.high) return Agreement::undecided;
    const double half = *computed.high - computed.value;
    if (off + half <= target.deviation) return Agreement::within;
    return off - half > target.deviation ? Agreement::outside : Agreement::undecided;
}

std::string comparison(const std::vector<SeedGroup>& groups, const std::vector<SizedEnvelope>& envelopes,
                       const std::optional<Material>& material, const std::string& caveats) {
    ComparisonTable table(material);
    bool has_envelopes = false;
    for (const LaboratoryProperty& property : laboratory_properties(material, tested_pressures(groups))) {
        if (!has_envelopes && !stands_before_envelope(property)) {
            add_envelope_rows(table, envelopes, material);
            has_envelopes = true;
        }
        table.add(property, groups);
    }
    std::string text = table.str() + caveats;
    if (!material) {
        text += html::paragraph("With --material FILE the laboratory's values of that material stand beside these.");
    } else if (material->fitted.empty()) {
        text += html::paragraph("This material has no [fitted]: no calibration says which values it was fitted to.");
    }
    if (material) {
        text += html::paragraph("Laboratory: [targets] and [laboratory] of " + material->file.filename().string() + ".");
    }
    text += html::paragraph(
        "CI and CD as strain gauges tell them, by the volumetric strain ε1 + 2 ε3 over the central half. CI: stress at which the "
        "crack volumetric strain sets in, which is that strain less its elastic line. CD: stress at which the volume begins to "
        "grow. E and ν: chord to half the peak. C and φ: line through the compression tests. UCS and σ1: first peaks; a "
        "test that did not fail has none.");
    text += other_thresholds(groups);
    if (const std::string fitted = fitted_table(material); !fitted.empty()) {
        text += "<h3>What the calibration fitted</h3>\n" + fitted;
    }
    return text;
}

}  // namespace graincrack
