#include "post/report/test_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <numbers>

#include "post/measure/caveats.hpp"
#include "post/measure/toughness.hpp"
#include "post/run/run_state.hpp"
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

/// Empty without a slit or a peak.
std::optional<double> toughness_of(const RunData& run, const Specimen& specimen) {
    try {
        return measure_toughness(run, specimen).mode_i_toughness;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace

FailureBranches count_branches(const std::vector<Crack>& log) {
    FailureBranches branches;
    for (const Crack& crack : log) {
        (crack.mode == CrackMode::tensile ? branches.open : branches.closed) += 0.5;
        if (crack.mode_angle < std::numbers::pi / 4) {
            branches.by_tension += 0.5;
        } else if (crack.mode_angle <= std::numbers::pi / 2) {
            branches.by_shear += 0.5;
        } else {
            branches.compressed += 0.5;
        }
        if (crack.separated.time < std::numeric_limits<double>::infinity()) branches.separated += 0.5;
    }
    return branches;
}

TestReport read_test_report(const RunReader& run) {
    TestReport report;
    report.data = run_data(run);
    report.curve = load_curve(report.data);
    report.strength = measure_strength(report.data);
    report.moduli = measure_moduli(report.data);
    const Specimen specimen = run.specimen();
    const std::vector<Crack> log = read_cracks(run, specimen);
    const RunHeader& header = report.data.header;
    const std::vector<Crack> cracks = labelled(log, {header.crack_event});
    report.predicted = predict_moduli(header, specimen);
    report.grains = grain_moduli(header, specimen);
    report.class_names = contact_class_names(specimen);
    if (is_compression(header)) report.thresholds = measure_all_thresholds(report.data, report.curve, log);
    if (header.test == "bend" && specimen.shape == "half-disc") report.mode_i_toughness = toughness_of(report.data, specimen);
    std::optional<BrazilianSplit> split;
    if (splits(report.data)) split = measure_split(report.data, report.curve, specimen, log);
    report.caveats = caveats_of(report.data, split);
    const auto& times = report.data.history[HistoryColumn::time];
    report.at_peak = balance_cracks(cracks, times[report.curve.peak]);
    report.by_sign_at_peak = count_other_labels(log, header.crack_event, times[report.curve.peak]).front();
    report.at_end = balance_cracks(cracks, times.back());
    report.broken = count_modes(log, {CrackEvent::broken, CrackModeRule::sign}, times.back());
    report.branches = count_branches(log);
    report.sensitivity = read_sensitivity(run.file());
    report.contact_zone_length =
        fpz::contact_zone_length(header.rock, header.plane, header.contact.fracture_energy, header.contact.tensile_strength);
    report.provenance = provenance_of(run.file());
    if (run.file().has(schema::provenance_group) && run.file().has_attribute(schema::provenance_group, "command_line")) {
        report.command_line = run.file().attribute<std::vector<std::string>>(schema::provenance_group, "command_line");
    }
    return report;
}

}  // namespace graincrack
