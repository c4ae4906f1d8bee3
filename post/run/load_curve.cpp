#include "post/run/load_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "post/run/crystals.hpp"
#include "share/base/error.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/probe_file.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

namespace {

using enum HistoryColumn;

std::vector<double> scaled(const std::vector<double>& values, double factor) {
    std::vector<double> out(values.size());
    std::transform(values.begin(), values.end(), out.begin(), [factor](double v) { return factor * v; });
    return out;
}

/// 2 F/(π t D), Eq 18, compression positive, with F the mean of the platen forces.
std::vector<double> brazilian_stress(const History& history, double diameter) {
    std::vector<double> stress(history.size());
    for (std::size_t i = 0; i < stress.size(); ++i) {
        const double force = -(history[force_top][i] + history[force_bottom][i]) / 2;
        stress[i] = 2 * force / (std::numbers::pi * diameter);
    }
    return stress;
}

/// Stress in bending over the axial stress of the history, which is the load over the extent along x.
double bending_factor(const RunData& run) {
    const SpecimenSummary& s = run.specimen;
    if (run.header.loading() != Loading::bending || s.shape != "beam") return 1;
    return 1.5 * s.width * run.header.span / (s.height * s.height);
}

/// Sizes, phases and scatter of the grains.
void summarize_grains(const H5Input& file, SpecimenSummary& summary) {
    summary.tessellation = file.attribute_or<std::string>(schema::specimen_group, "tessellation", "");
    if (const std::optional<CrystalSizes> sizes = sizes_of_grains(file)) {
        summary.crystals = static_cast<std::int64_t>(sizes->n);
        summary.grain_diameter = sizes->mean_diameter;
        summary.elements_per_crystal = sizes->elements;
        summary.area = sizes->area;
    }
    const auto names = file.attribute_or<std::vector<std::string>>(schema::grain_phase.path, "names", {});
    const auto fractions = file.attribute_or<std::vector<double>>(schema::grain_phase.path, "fractions", {});
    for (std::size_t p = 0; p < std::min(names.size(), fractions.size()); ++p) summary.phases[names[p]] = fractions[p];
    summary.has_strength_factors = file.has(schema::contact_strength_factor.path);
}

/// A NaN in the stress would make the search for the largest stress end there. \throws InputError
void require_numbers(const LoadCurve& curve, const std::string& name) {
    for (std::size_t row = 0; row < curve.stress.size(); ++row) {
        if (std::isfinite(curve.stress[row]) && std::isfinite(curve.axial_strain[row])) continue;
        throw InputError(name + ": row " + std::to_string(row) +
                         " of /history has a stress or strain that is no number; the run failed there");
    }
}

}  // namespace

SpecimenSummary specimen_summary(const H5Input& file) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    SpecimenSummary summary;
    summary.shape = file.attribute_or<std::string>(schema::specimen_group, "shape", "");
    const std::vector<std::uint8_t> kinds = file.read<std::uint8_t>(schema::contact_kind.path);
    const auto cracked = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
    summary.is_cracked = std::ranges::find(kinds, cracked) != kinds.end();
    summary.width = file.attribute<double>(schema::specimen_group, "width");
    summary.height = file.attribute<double>(schema::specimen_group, "height");
    summary.seed = file.attribute_or<std::int64_t>(schema::specimen_group, "seed", 0);
    summary.mean_edge = file.attribute_or<double>(schema::specimen_group, "mean_edge", unknown);
    summary.grains = static_cast<std::int64_t>(rows_of(file, schema::grain_phase.path));
    const auto parts = file.attribute_or<std::vector<std::string>>(schema::boundary_part.path, "names", {});
    summary.holes =
        static_cast<std::size_t>(std::ranges::count_if(parts, [](const std::string& part) { return part.starts_with("hole_"); }));
    summarize_grains(file, summary);
    summary.settings = read_settings(file, schema::specimen_group);
    return summary;
}

RunData run_data(const RunReader& run, const CrackLabelChoice& label) {
    const H5Input& file = run.file();
    RunData data{run.name(),
                 run.header(),
                 run.history(),
                 specimen_summary(file),
                 run.wall_time(),
                 file.attribute_or<std::string>(schema::provenance_group, "input_digest", ""),
                 file.attribute_or<std::string>(schema::program_group, "text", "")};
    const std::vector<Crack> log = run.cracks();
    const CrackLabel shown = label.of(run.header());
    if (shown.event != run.header().crack_event) {
        count_in_history(labelled(log, {run.header().crack_event, shown.mode}), data.history);
        data.failed = failed_contacts(data.history);
    }
    count_in_history(labelled(log, shown), data.history);
    return data;
}

RunData read_run_data(const std::string& path) { return run_data(RunReader(path)); }

std::vector<RunData> read_runs(const std::vector<std::string>& paths) {
    std::vector<RunData> runs;
    runs.reserve(paths.size());
    for (const std::string& path : paths) runs.push_back(read_run_data(path));
    return runs;
}

LoadCurve load_curve(const RunData& run) {
    const History& history = run.history;
    if (history.size() < 3) {
        throw InputError(run.name + ": /history has " + std::to_string(history.size()) + " rows; a curve needs at least 3");
    }
    const double sense = run.header.loading() == Loading::tension ? 1 : -1;
    LoadCurve curve;
    curve.axial_strain = scaled(history[axial_strain], sense);
    curve.gauge_axial_strain = scaled(history[gauge_axial_strain], sense);
    curve.lateral_strain = history[lateral_strain];
    curve.gauge_lateral_strain = history[gauge_lateral_strain];
    curve.stress = run.header.loading() == Loading::splitting ? brazilian_stress(history, run.specimen.width)
                                                              : scaled(history[axial_stress], sense * bending_factor(run));
    curve.failed = run.failed.empty() ? failed_contacts(history) : run.failed;

    require_numbers(curve, run.name);

    const auto& times = history[HistoryColumn::time];
    const auto begin = std::lower_bound(times.begin(), times.end(), run.header.isotropic_end_time * (1 - 1e-12));
    curve.start = static_cast<std::size_t>(begin - times.begin());
    if (curve.start + 2 > history.size()) {
        throw InputError(run.name + ": the history ends before axial loading begins; run the test further");
    }
    const auto from = curve.stress.begin() + static_cast<std::ptrdiff_t>(curve.start);
    curve.largest = static_cast<std::size_t>(std::max_element(from, curve.stress.end()) - curve.stress.begin());
    const double largest = curve.stress[curve.largest];
    if (!(largest > 0) || !(largest > curve.start_stress())) {
        throw InputError(run.name + ": the stress never rises in the sense of a " + run.header.test +
                         " test; expected a history of a specimen that was loaded");
    }
    curve.strength = find_strength(run.header, curve.loaded());
    if (curve.strength) curve.strength->row += curve.start;
    curve.peak = curve.strength ? curve.strength->row : curve.largest;
    return curve;
}

std::optional<LoadCurve> load_curve_if_any(const RunData& run) {
    try {
        return load_curve(run);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

CurveColumns LoadCurve::loaded() const {
    const auto rows = [&](const std::vector<double>& column) { return std::span(column).subspan(start); };
    return {rows(axial_strain), rows(stress), rows(failed)};
}

namespace {

double range_of(const std::vector<double>& values) {
    const auto [low, high] = std::ranges::minmax_element(values);
    return *high - *low;
}

std::vector<double> column_of(const ProbeHistory& probe, const std::string& name) {
    for (std::size_t c = 0; c < probe.columns.size(); ++c) {
        if (probe.columns[c].name == name) return probe.values[c];
    }
    return {};
}

}  // namespace

LoadCourse load_course(const RunReader& run, const RunData& data) {
    if (const auto curve = load_curve_if_any(data)) {
        LoadCourse course{"axial strain", "%", stress_name(data), "MPa", scaled(curve->axial_strain, 100), curve->stress};
        for (std::size_t row = 0; row < course.y.size(); ++row) course.y[row] = 1e-6 * curve->shown_stress(row);
        return course;
    }
    const History& history = data.history;
    LoadCourse course{"time",
                      "ms",
                      "axial stress, tension positive",
                      "MPa",
                      scaled(history[HistoryColumn::time], 1e3),
                      scaled(history[HistoryColumn::axial_stress], 1e-6)};
    double most = 0;
    for (const std::string& name : probe_names(run.file())) {
        const ProbeHistory probe = read_probe(run.file(), name);
        for (const std::string along : {"x", "y"}) {
            const std::vector<double> way = column_of(probe, "displacement_" + along), force = column_of(probe, "force_" + along);
            if (way.empty() || way.size() != history.size() || force.size() != history.size()) continue;
            const double both = range_of(way) * range_of(force);
            if (!(both > most)) continue;
            most = both;
            course = {
                "displacement of " + name + " along " + along, "mm", "force", "kN/m", scaled(way, 1e3), scaled(force, 1e-3)};
        }
    }
    return course;
}

std::size_t row_at(const History& history, double time) {
    const std::vector<double>& times = history[HistoryColumn::time];
    const auto reached = std::lower_bound(times.begin(), times.end(), time);
    return static_cast<std::size_t>(std::min(reached, times.end() - 1) - times.begin());
}

double CurvePoint::of(const std::vector<double>& column) const {
    if (share == 0) return column[row];
    return column[row] + share * (column[row + 1] - column[row]);
}

CurvePoint share_of_peak(const LoadCurve& curve, double share) {
    const double wanted = curve.start_stress() + (curve.stress[curve.peak] - curve.start_stress()) * share;
    std::size_t row = curve.start;
    while (row + 1 < curve.peak && curve.stress[row + 1] < wanted) ++row;
    return {row, (wanted - curve.stress[row]) / (curve.stress[row + 1] - curve.stress[row])};
}

RowRange rows_between(const LoadCurve& curve, double low_share, double high_share) {
    return {share_of_peak(curve, low_share).row, share_of_peak(curve, high_share).row + 2};
}

std::optional<double> first_yield(const LoadCurve& curve) {
    const CurvePoint half = half_peak(curve);
    const double strain_start = curve.axial_strain[curve.start];
    const double compliance = (half.of(curve.axial_strain) - strain_start) / (half.of(curve.stress) - curve.start_stress());
    const auto offset = [&](std::size_t row) {
        return curve.axial_strain[row] - strain_start - compliance * (curve.stress[row] - curve.start_stress());
    };
    for (std::size_t row = half.row + 1; row <= curve.peak; ++row) {
        const double now = offset(row);
        if (now < yield_offset) continue;
        const double before = row == half.row + 1 ? 0.0 : offset(row - 1);
        const double share = now > before ? std::clamp((yield_offset - before) / (now - before), 0.0, 1.0) : 1.0;
        return curve.stress[row - 1] + share * (curve.stress[row] - curve.stress[row - 1]);
    }
    return std::nullopt;
}

std::optional<double> stress_at_strain(const LoadCurve& curve, double strain) {
    for (std::size_t row = curve.start; row < curve.stress.size(); ++row) {
        const double now = curve.axial_strain[row];
        if (now < strain) continue;
        if (row == curve.start) return curve.stress[row];
        const double before = curve.axial_strain[row - 1];
        return CurvePoint{row - 1, (strain - before) / (now - before)}.of(curve.stress);
    }
    return std::nullopt;
}

std::string stress_name(const RunData& run) {
    if (run.header.loading() == Loading::splitting) return "2F/(πtD)";
    if (run.header.loading() == Loading::bending) return run.specimen.shape == "beam" ? "3FS/(2tH²)" : "F/(tD)";
    return "axial stress";
}

bool is_compression(const RunSettings& header) { return header.loading() == Loading::compression; }

double decisive_drop(const RunSettings& header) {
    // A test may be continued far beyond the drop that makes its largest stress a peak.
    constexpr double usual_drop = 0.3;
    return header.peak_drop > 0 ? std::min(header.peak_drop, usual_drop) : usual_drop;
}

std::string peak_kind(const RunHeader& header, bool has_failed) {
    if (has_failed) return "drop";
    return header.stop_reason == "strain limit" ? "cap" : "";
}

}  // namespace graincrack
