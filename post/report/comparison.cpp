#include "post/report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "post/measure/grain_size.hpp"
#include "post/report/html.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

using html::number;
using ValueOfTest = std::function<std::optional<double>(const TestReport&)>;

/// The runs of one grain size.
struct SizedTests {
    std::string size;  ///< "edge 5 mm"; empty if all are of one size
    std::vector<const TestReport*> tests;
};

std::vector<SizedTests> by_size(const std::vector<TestReport>& tests) {
    std::vector<double> edges;
    for (const TestReport& t : tests) edges.push_back(t.data.specimen.mean_edge);
    const std::vector<GrainSize> sizes = grain_sizes(edges);
    std::vector<SizedTests> sets;
    for (const GrainSize& size : sizes) {
        SizedTests set{sizes.size() > 1 ? size.label : "", {}};
        for (const std::size_t i : size.runs) set.tests.push_back(&tests[i]);
        sets.push_back(std::move(set));
    }
    return sets;
}

std::string with_size(const std::string& label, const std::string& size) { return size.empty() ? label : label + ", " + size; }

/// Rows of one of the tables.
class ComparisonColumn {
public:
    explicit ComparisonColumn(const std::optional<Material>& material)
        : material_(material),
          table_({"quantity", "model\u00a0(s.d.;\u00a0n)\n95\u00a0%\u00a0interval", "laboratory", "difference"}) {}

    /// Samples over runs, a row for each grain size. \param key of [laboratory], "" for none \param factor from SI to the unit
    /// of the row
    void add(const std::string& label, const std::vector<SizedTests>& sets, const ValueOfTest& value, const std::string& key,
             double factor) {
        for (const SizedTests& set : sets) {
            std::vector<double> values;
            for (const TestReport* t : set.tests) {
                if (const auto v = value(*t)) values.push_back(*v);
            }
            if (values.empty()) continue;
            const Sample s = sample(values);
            std::string mean = number(s.mean.value * factor);
            mean += s.deviation ? fmt::format(" ({}; {})", number(*s.deviation * factor, 2), s.n) : " (1 run)";
            row(with_size(label, set.size), mean, s.mean, key, factor);
        }
    }
    /// A fit over the set.
    void add(const std::string& label, const Estimate& value, const std::string& key, double factor) {
        row(label, number(value.value * factor), value, key, factor);
    }
    [[nodiscard]] bool empty() const { return table_.empty(); }
    [[nodiscard]] std::string str(const std::string& heading, const std::string& note = "") const {
        return "<div><h3>" + html::escaped(heading) + "</h3>" +
               (table_.empty() ? html::paragraph("nothing in this set") : table_.str()) +
               (note.empty() ? "" : html::paragraph(note)) + "</div>\n";
    }

private:
    void row(const std::string& label, std::string mean, const Estimate& value, const std::string& key, double factor) {
        if (value.low) mean += "\n" + number(*value.low * factor, 4) + " to " + number(*value.high * factor, 4);
        std::string laboratory;
        std::string difference;
        if (material_ && material_->laboratory.count(key) > 0) {
            const double measured = material_->laboratory.at(key);
            laboratory = number(measured * factor);
            difference = fmt::format("{:+.1f} %", 100 * (value.value / measured - 1));
        }
        table_.row({label, mean, laboratory, difference});
    }
    const std::optional<Material>& material_;
    html::Table table_;
};

ValueOfTest strength_of(const std::string& test, double confining) {
    return [=](const TestReport& t) -> std::optional<double> {
        const bool is_asked = t.data.header.test == test && t.data.header.confining_pressure == confining;
        if (!is_asked || !distinct_shape(t.data).empty()) return std::nullopt;
        return t.strength.value();
    };
}

std::vector<double> pressures(const std::vector<TestReport>& tests) {
    std::vector<double> values;
    for (const TestReport& t : tests) {
        const double p = t.data.header.confining_pressure;
        if (t.data.header.test == "triaxial" && std::find(values.begin(), values.end(), p) == values.end()) values.push_back(p);
    }
    std::sort(values.begin(), values.end());
    return values;
}

/// Where a row belongs: the column of its property.
using ComparisonColumnOf = std::function<ComparisonColumn&(const std::string& property)>;

void add_compared_strengths(const ComparisonColumnOf& column, const std::vector<TestReport>& tests,
                            const std::vector<SizedTests>& sets, const std::vector<SizedEnvelope>& envelopes) {
    column("tensile_strength").add("σt, Brazilian, MPa", sets, strength_of("brazilian", 0), "tensile_strength", in_megapascals);
    column("compressive_strength").add("UCS, MPa", sets, strength_of("uniaxial", 0), "compressive_strength", in_megapascals);
    for (const double p : pressures(tests)) {
        column(fmt::format("confined_strength_{:g}MPa", p * in_megapascals))
            .add(fmt::format("σ1 at {} MPa, MPa", number(p * in_megapascals)), sets, strength_of("triaxial", p), "",
                 in_megapascals);
    }
    for (const SizedEnvelope& each : envelopes) {  // follows from UCS and strengths under pressure
        column("envelope").add(with_size("C, MPa", each.size), each.envelope.cohesion, "cohesion", in_megapascals);
        column("envelope").add(with_size("φ, °", each.size), each.envelope.friction_angle, "friction_angle", in_degrees);
    }
    column("direct_tensile_strength").add("direct tensile strength, MPa", sets, strength_of("tension", 0), "", in_megapascals);
}

void add_compared_moduli(const ComparisonColumnOf& column, const std::vector<SizedTests>& sets) {
    const auto uniaxial = [](const ValueOfTest& value) {
        return [value](const TestReport& t) { return t.data.header.test == "uniaxial" ? value(t) : std::nullopt; };
    };
    const auto modulus = [](double ElasticPair::*member) {
        return [member](const TestReport& t) { return t.moduli ? std::optional(t.moduli->chord.*member) : std::nullopt; };
    };
    column("young_modulus")
        .add("E, chord to ½ peak, GPa", sets, uniaxial(modulus(&ElasticPair::young_modulus)), "young_modulus", 1e-9);
    column("poisson_ratio").add("ν, chord to ½ peak", sets, uniaxial(modulus(&ElasticPair::poisson_ratio)), "poisson_ratio", 1);
    column("crack_initiation")
        .add("crack initiation (1 % of cracks), MPa", sets, uniaxial([](const TestReport& t) { return t.initiation; }), "",
             in_megapascals);
    for (std::size_t level = 0; level < std::tuple_size_v<InitiationByDamage>; ++level) {
        constexpr const char* percents[] = {"10", "50", "90"};
        column("crack_initiation")
            .add(fmt::format("crack initiation (1 % of points damaged by {} %), MPa", percents[level]), sets,
                 uniaxial([level](const TestReport& t) { return t.initiation_by_damage[level]; }), "", in_megapascals);
    }
    column("crack_damage")
        .add("crack damage (2D volume), MPa", sets,
             uniaxial([](const TestReport& t) { return t.thresholds ? t.thresholds->damage : std::nullopt; }), "",
             in_megapascals);
}

}  // namespace

std::string comparison_columns(const std::vector<TestReport>& tests, const std::vector<SizedEnvelope>& envelopes,
                               const std::optional<Material>& material) {
    ComparisonColumn fitted(material);
    ComparisonColumn others(material);
    const FittedProperties known = material ? material->fitted : FittedProperties{};
    const bool line_is_fitted =
        std::any_of(known.begin(), known.end(), [](const auto& p) { return p.first.starts_with("confined_strength"); });
    const ComparisonColumnOf column_of = [&](const std::string& property) -> ComparisonColumn& {
        return known.count(property) > 0 || (property == "envelope" && line_is_fitted) ? fitted : others;
    };
    const std::vector<SizedTests> sets = by_size(tests);
    add_compared_strengths(column_of, tests, sets, envelopes);
    add_compared_moduli(column_of, sets);
    if (known.empty()) {
        return "<div class=\"columns\">\n" +
               others.str("Results",
                          "This material has no [fitted], so it is not known what was fitted and what is a prediction.") +
               "</div>\n";
    }
    std::string note = "The calibration:";
    for (const auto& [property, text] : known) note += fmt::format(" {}: {}.", property, text);
    return "<div class=\"columns\">\n" + fitted.str("Fitted by the calibration", note) + others.str("Predicted, not fitted") +
           "</div>\n";
}

}  // namespace graincrack
