#include "post/report/test_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "post/measure/caveats.hpp"
#include "post/measure/toughness.hpp"
#include "post/report/html.hpp"
#include "post/run/comparability.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

namespace {

ProvenanceEntries provenance_of(const H5Input& file) {
    const char* group = schema::provenance_group;
    ProvenanceEntries entries;
    if (!file.has(group)) return entries;
    const auto text = [&](const char* name) {
        if (file.has_attribute(group, name)) entries.emplace_back(name, file.attribute<std::string>(group, name));
    };
    const auto list = [&](const char* name) {
        if (!file.has_attribute(group, name)) return;
        entries.emplace_back(name, fmt::format("{}", fmt::join(file.attribute<std::vector<std::string>>(group, name), " ")));
    };
    for (const char* name : {"tool", "version", "commit", "utc_time", "input_digest"}) text(name);
    list("command_line");
    list("libraries");
    return entries;
}

/// Nothing without a slit or a peak.
void add_toughness(MeasuredRun& report, const Specimen& specimen) {
    try {
        const Toughness toughness = measure_toughness(report.data, specimen);
        report.mode_i_toughness = toughness.mode_i_toughness;
        report.bend = ToughnessTest{specimen.shape, toughness.size, toughness.notch_length, report.data.header.span};
    } catch (const InputError&) {
        return;
    }
}

}  // namespace

TestReport read_test_report(const RunReader& run, const CrackLabelChoice& label) {
    TestReport report;
    report.data = run_data(run, label);
    report.curve = load_curve(report.data);
    report.strength = measure_strength(report.data, report.curve);
    report.moduli = measure_moduli(report.data);
    const Specimen specimen = run.specimen();
    const std::vector<Crack> log = read_cracks(run, specimen);
    const RunHeader& header = report.data.header;
    const std::vector<Crack> cracks = labelled(log, label.of(header));
    report.class_names = contact_class_names(specimen);
    if (is_compression(header)) report.thresholds = measure_all_thresholds(report.data, report.curve, log);
    if (header.loading() == Loading::bending) add_toughness(report, specimen);
    std::optional<BrazilianSplit> split;
    if (splits(report.data)) split = measure_split(report.data, report.curve, specimen, log);
    report.caveats = caveats_of(report.data, split);
    const auto& times = report.data.history[HistoryColumn::time];
    report.at_peak = balance_cracks(cracks, times[report.curve.peak]);
    report.by_sign_at_peak = count_other_labels(log, header.crack_event, times[report.curve.peak]).front();
    report.crack_definition = definition_of(label.of(header));
    report.at_end = balance_cracks(cracks, times.back());
    report.sensitivity = read_sensitivity(run.file());
    report.contact_zone_length =
        fpz::contact_zone_length(header.rock, header.plane, header.contact.fracture_energy, header.contact.tensile_strength);
    report.provenance = provenance_of(run.file());
    if (run.file().has(schema::provenance_group)) {
        report.material = run.file().attribute_or<std::string>(schema::provenance_group, "material", "");
    }
    return report;
}

namespace {

using html::number;

/// Mean strength over that of the discs of the same material and fabric.
std::string ratio_to_brazilian(const std::vector<SeedGroup>& groups, const SeedGroup& group) {
    const auto is_of_its_rock = [&](const SeedGroup& each) {
        return each.first().data.header.loading() == Loading::splitting && distinct_shape(each.first().data).empty() &&
               differences(each.first().data, group.first().data, of_the_test).empty();
    };
    const auto disc = std::find_if(groups.begin(), groups.end(), is_of_its_rock);
    if (disc == groups.end() || is_of_its_rock(group) || std::count_if(disc, groups.end(), is_of_its_rock) > 1) return "";
    const auto own = group.sample_of(strength_of);
    const auto brazilian = disc->sample_of(strength_of);
    return own && brazilian ? number(own->mean.value / brazilian->mean.value, 3) : "";
}

}  // namespace

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
        std::optional<double> (*of)(const MeasuredRun&);
    };
    const auto of = [](const char* head, double factor, const char* property) {
        return Value{head, factor, property_named(property).value};
    };
    const Value values[] = {{"strength (compression: first peak), MPa", in_megapascals, strength_of},
                            of("strain at peak, %", 100, "strain_at_peak"),
                            of("E, GPa", 1e-9, "young_modulus"),
                            of("ν", 1, "poisson_ratio"),
                            of("CI, MPa", in_megapascals, "crack_initiation"),
                            of("CD, MPa", in_megapascals, "crack_damage")};
    std::vector<std::string> head{"test", "plane", "runs"};
    for (const Value& value : values) head.emplace_back(value.head);
    head.insert(head.end(), {did_not_fail, "over Brazilian"});
    html::Table table(head);
    for (const SeedGroup& group : groups) {
        std::vector<std::string> row{group.name(), std::string(name_of(group.first().data.header.plane)),
                                     std::to_string(group.runs.size())};
        for (const Value& value : values) {
            const auto sample = group.sample_of(value.of);
            row.push_back(sample ? mean_cell(*sample, value.factor) : "");
        }
        row.push_back(std::to_string(
            std::count_if(group.runs.begin(), group.runs.end(), [](const MeasuredRun* t) { return !t->strength.has_peak(); })));
        row.push_back(ratio_to_brazilian(groups, group));
        table.row(std::move(row));
    }
    return table.str();
}

}  // namespace graincrack
