#include "post/report/seed_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/measure/grain_size.hpp"
#include "post/report/html.hpp"
#include "post/run/comparable.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"

namespace graincrack {

namespace {

using html::number;

bool is_same_length(double a, double b) { return !(std::abs(a - b) > 1e-6 * std::abs(b)); }

bool differ_by_seed_alone(const TestReport& a, const TestReport& b) {
    const SpecimenSummary& first = a.data.specimen;
    const SpecimenSummary& second = b.data.specimen;
    return a.data.header.test == b.data.header.test && a.data.header.confining_pressure == b.data.header.confining_pressure &&
           first.shape == second.shape && distinct_shape(a.data) == distinct_shape(b.data) &&
           is_same_length(first.width, second.width) && is_same_length(first.height, second.height) &&
           material_difference(a.data.header, b.data.header).empty() && setting_difference(a.data.header, b.data.header).empty();
}

std::string lengths_label(const SpecimenSummary& specimen) {
    const std::string width = number(specimen.width * 1e3);
    const std::string height = number(specimen.height * 1e3);
    return width == height ? width + " mm" : width + " × " + height + " mm";
}

/// Brazilian, tension, compression by rising pressure.
std::pair<int, double> place_of(const SeedGroup& group) {
    const RunHeader& header = group.first().data.header;
    return {header.test == "brazilian" ? 0 : is_compression(header) ? 2 : 1, header.confining_pressure};
}

/// Names the lengths of specimens where groups of one test and grain size differ in them.
void tell_apart(std::vector<SeedGroup>& groups) {
    std::vector<std::string> names;
    for (const SeedGroup& group : groups) names.push_back(group.name());
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (std::count(names.begin(), names.end(), names[i]) < 2) continue;
        groups[i].lengths = lengths_label(groups[i].first().data.specimen);
    }
}

/// Mean strength over that of the discs of the same grain size.
std::string ratio_to_brazilian(const std::vector<SeedGroup>& groups, const SeedGroup& group) {
    const auto disc = std::find_if(groups.begin(), groups.end(), [&](const SeedGroup& each) {
        return each.first().data.header.test == "brazilian" && distinct_shape(each.first().data).empty() &&
               each.grain_size == group.grain_size;
    });
    if (disc == groups.end() || &*disc == &group) return "";
    return number(group.sample_of(strength_of)->mean.value / disc->sample_of(strength_of)->mean.value, 3);
}

}  // namespace

std::string SeedGroup::with_specimen(const std::string& text) const {
    return text + (grain_size.empty() ? "" : ", " + grain_size) + (lengths.empty() ? "" : ", " + lengths);
}

std::optional<Sample> SeedGroup::sample_of(const ValueOfTest& value) const {
    std::vector<double> values;
    for (const TestReport* run : runs) {
        if (const auto own = value(*run)) values.push_back(*own);
    }
    return values.empty() ? std::nullopt : std::optional(sample(values));
}

std::vector<SeedGroup> seed_groups(const std::vector<TestReport>& tests) {
    std::vector<double> edges;
    for (const TestReport& test : tests) edges.push_back(test.data.specimen.mean_edge);
    const std::vector<GrainSize> sizes = grain_sizes(edges);
    std::vector<SeedGroup> groups;
    for (const GrainSize& size : sizes) {
        const auto first_of_size = static_cast<std::ptrdiff_t>(groups.size());
        for (const std::size_t i : size.runs) {
            auto group = std::find_if(groups.begin() + first_of_size, groups.end(),
                                      [&](const SeedGroup& each) { return differ_by_seed_alone(tests[i], each.first()); });
            if (group == groups.end()) {
                group = groups.insert(group, {series_label(tests[i].data), sizes.size() > 1 ? size.label : "", "", {}});
            }
            group->runs.push_back(&tests[i]);
        }
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const SeedGroup& a, const SeedGroup& b) { return place_of(a) < place_of(b); });
    tell_apart(groups);
    return groups;
}

double strength_of(const TestReport& test) { return test.strength.reported(); }

std::string mean_cell(const Sample& sample, double factor) {
    std::string text = number(sample.mean.value * factor);
    if (sample.deviation) text += " (" + number(*sample.deviation * factor, 2) + ")";
    if (sample.mean.low) text += "\n" + number(*sample.mean.low * factor) + " to " + number(*sample.mean.high * factor);
    return text;
}

std::string group_table(const std::vector<SeedGroup>& groups) {
    struct Value {
        const char* head;
        double factor;
        ValueOfTest of;
    };
    const std::vector<Value> values{
        {"strength, MPa", in_megapascals, strength_of},
        {"strain at peak, %", 100, [](const TestReport& t) { return t.strength.strain_at_peak; }},
        {"E, GPa", 1e-9,
         [](const TestReport& t) { return t.moduli ? std::optional(t.moduli->chord.young_modulus) : std::nullopt; }},
        {"ν", 1, [](const TestReport& t) { return t.moduli ? std::optional(t.moduli->chord.poisson_ratio) : std::nullopt; }},
        {"CI, MPa", in_megapascals, [](const TestReport& t) { return t.threshold(&AllThresholds::initiation); }},
        {"CD, MPa", in_megapascals, [](const TestReport& t) { return t.threshold(&AllThresholds::damage); }}};
    std::vector<std::string> head{"test", "plane", "runs"};
    for (const Value& value : values) head.emplace_back(value.head);
    head.insert(head.end(), {"without peak", "over Brazilian"});
    html::Table table(head);
    for (const SeedGroup& group : groups) {
        std::vector<std::string> row{group.name(), std::string(name_of(group.first().data.header.plane)),
                                     std::to_string(group.runs.size())};
        for (const Value& value : values) {
            const auto sample = group.sample_of(value.of);
            row.push_back(sample ? mean_cell(*sample, value.factor) : "");
        }
        row.push_back(std::to_string(std::count_if(group.runs.begin(), group.runs.end(),
                                                   [](const TestReport* t) { return t->strength.peak_kind != "drop"; })));
        row.push_back(ratio_to_brazilian(groups, group));
        table.row(std::move(row));
    }
    return table.str();
}

}  // namespace graincrack
