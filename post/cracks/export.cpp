#include "post/cracks/export.hpp"

#include <fmt/format.h>
#include <array>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "post/cracks/crack_counts.hpp"
#include "post/cracks/crack_map.hpp"
#include "post/cracks/emission.hpp"
#include "post/cracks/fragments.hpp"
#include "post/cracks/rosette.hpp"
#include "post/options/command.hpp"
#include "post/run/contact_classes.hpp"
#include "post/run/load_curve.hpp"
#include "post/run/run_state.hpp"
#include "post/table/column.hpp"
#include "post/table/table.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/file/output_file.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

/// A moment of a run, and at its end what it has become.
struct SummaryRow {
    std::string file, at;
    double time = 0;  ///< s
    std::optional<double> axial_strain;
    CrackBalance balance;
    std::optional<std::size_t> fragments, single_grains, events;
    std::optional<GutenbergRichter> fit;  ///< of the events, if they follow a line
    Cell peak_kind;
    OtherCounts counts;
    Rosette rosette;
    ModeCounts crystals;  ///< that are cracked
    [[nodiscard]] Cell of_fit(double GutenbergRichter::*value) const { return fit ? Cell((*fit).*value) : Cell(); }
};

const Columns<SummaryRow>& summary_columns() {
    using R = SummaryRow;
    using namespace unit;
    static const Columns<R> all = [] {
        Columns<R> list{{"file", none, [](const R& r) { return r.file; }},
                        {"at", none, [](const R& r) { return r.at; }},
                        {"time", second, [](const R& r) { return r.time; }},
                        {"axial_strain", none, [](const R& r) { return r.axial_strain; }},
                        {"tensile_cracks", none, [](const R& r) { return count_cell(r.balance.tensile); }},
                        {"shear_cracks", none, [](const R& r) { return count_cell(r.balance.shear); }},
                        {"separated", none, [](const R& r) { return count_cell(r.balance.separated); }},
                        {"fragments", none, [](const R& r) { return r.fragments; }},
                        {"single_grains", none, [](const R& r) { return r.single_grains; }},
                        {"events", none, [](const R& r) { return r.events; }},
                        {"b_value", none, [](const R& r) { return r.of_fit(&GutenbergRichter::b); }},
                        {"b_value_error", none, [](const R& r) { return r.of_fit(&GutenbergRichter::error); }},
                        {"b_value_completeness", none, [](const R& r) { return r.of_fit(&GutenbergRichter::completeness); }},
                        {"b_value_events", none, [](const R& r) { return r.fit ? Cell(r.fit->events) : Cell(); }},
                        {"peak_kind", none, [](const R& r) { return r.peak_kind; }}};
        append_other_counts<R>(list, [](const R& r) -> const OtherCounts& { return r.counts; });
        const auto sum = [](const R& r) { return std::accumulate(r.rosette.tensile.begin(), r.rosette.tensile.end(), 0.0); };
        list.push_back({"tensile_length", metre, sum});
        list.push_back({"tensile_share_within_30_deg", none, [](const R& r) { return share_along_load(r.rosette.tensile); }});
        list.push_back({"facet_share_within_30_deg", none, [](const R& r) { return share_along_load(r.rosette.facet); }});
        list.push_back({"tensile_cracked_crystals", none, [](const R& r) { return count_cell(r.crystals.tensile); }});
        list.push_back({"shear_cracked_crystals", none, [](const R& r) { return count_cell(r.crystals.shear); }});
        return list;
    }();
    return all;
}

/// The rows of a crack log, and what they belong to.
struct CrackRows {
    const std::vector<Crack>& all;
    const Specimen& specimen;
    CrackLabel label;  ///< of the modes, of separation and of directions
};

/// Table: one row at the peak, if there is a curve, one at the end. Emission and fragments are given in the row of the end only.
void write_crack_summary(std::ostream& out, const RunData& run, const std::optional<LoadCurve>& curve, const CrackRows& log,
                         const std::vector<EmissionEvent>& events, const Fragments& fragments, TableFormat format) {
    const std::vector<Crack> cracks = labelled(log.all, log.label);
    const auto row_at = [&](const char* at, std::size_t index) {
        SummaryRow row{run.name, at, run.history[HistoryColumn::time][index], {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
        if (curve) {
            row.axial_strain = curve->axial_strain[index];
            row.peak_kind = peak_kind(run.header, curve->strength.has_value());
        }
        row.balance = balance_cracks(cracks, row.time);
        row.counts = count_other_labels(log.all, run.header.crack_event, row.time);
        row.crystals = count_cracked_crystals(log.specimen, cracks, row.time);
        row.rosette = crack_rosette(cracks_until(cracks, row.time), log.specimen);
        return row;
    };
    std::vector<SummaryRow> rows;
    if (curve) rows.push_back(row_at("peak", curve->peak));
    SummaryRow& end = rows.emplace_back(row_at("end", run.history.size() - 1));
    end.fragments = fragments.all.size();
    end.single_grains = fragments.single_grains();
    end.events = events.size();
    const std::vector<double> magnitudes = magnitudes_of(events);
    if (!magnitudes.empty()) end.fit = fit_gutenberg_richter(magnitudes, completeness_of(magnitudes));
    if (end.fit && !end.fit->follows_line()) end.fit.reset();
    write_table(out, summary_columns(), rows, format);
}

/// Files of one kind in a series: "grains_0000.vtu", …
struct Part {
    std::string stem;
    std::string suffix;
};

/// A list of files by time; several parts are blocks of one data set.
std::string pvd(const std::vector<Part>& parts, const std::vector<double>& times) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
    for (std::size_t i = 0; i < times.size(); ++i) {
        for (std::size_t part = 0; part < parts.size(); ++part) {
            const auto& [stem, suffix] = parts[part];
            text += fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}_{:04}.{}\" name=\"{}\"/>\n", times[i], part,
                                stem, i, suffix, stem);
        }
    }
    return text + "  </Collection>\n</VTKFile>\n";
}

void write_table(const std::string& path, const std::function<void(std::ostream&)>& write) {
    std::ostringstream text;
    write(text);
    write_whole_file(path, text.str());
}

/// Fragments and crystals of the last frame.
struct Breakup {
    Fragments last;
    std::vector<Crystal> crystals;  ///< in the last frame, if the specimen has any
};

/// Frames of different times: of two at one time, such as an evenly spaced one and the last, the later.
std::vector<std::size_t> distinct_frames(const std::vector<double>& times) {
    std::vector<std::size_t> frames;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (i + 1 == times.size() || times[i + 1] > times[i]) frames.push_back(i);
    }
    return frames;
}

/// The data with which the frames of a run are written.
struct Series {
    const RunReader& run;
    const Specimen& specimen;
    const RunData& data;
    const std::vector<Crack>& cracks;
    const CrackLabel& label;
    std::string folder;
    PlatenFaceSet platens;
    /// Platens press on the specimen, and move as the history says; those of direct tension are its own ends.
    [[nodiscard]] bool has_platens() const { return data.header.loading() != Loading::tension && data.header.max_strain > 0; }
};

/// Load and strain in the row of the history at, or next after, a time.
FrameMoment moment_of(const RunData& data, double time) {
    if (data.history.size() == 0) return {time, 0, 0};
    const std::size_t row = row_at(data.history, time);
    return {time, data.history[HistoryColumn::axial_strain][row], data.history[HistoryColumn::axial_stress][row]};
}

Breakup write_frames(const Series& series, const std::vector<std::size_t>& frames, Verbosity verbosity) {
    Progress progress("cracks", verbosity);
    Breakup breakup;
    const std::size_t n = frames.size();
    const bool has_crystals = !series.specimen.grain_crystal.empty();
    for (std::size_t i = 0; i < n; ++i) {
        throw_if_interrupted();
        Frame frame = read_frame(series.run, series.specimen, frames[i]);
        const FrameMoment moment = moment_of(series.data, frame.time);
        const auto file = [&](const char* stem, const char* suffix) {
            return fmt::format("{}/{}_{:04}.{}", series.folder, stem, i, suffix);
        };
        breakup.last = find_fragments(series.specimen, frame.state);
        if (i + 1 == n && has_crystals) {
            breakup.crystals = find_crystals(series.specimen, series.cracks, frame.state, breakup.last);
        }
        write_cracks(file("cracks", "vtp"), series.specimen, series.cracks, frame, series.label,
                     series.data.header.fabric.contacts, moment);
        if (series.has_platens()) write_platens(file("platens", "vtp"), series.platens, series.specimen.height, moment);
        write_grains(file("grains", "vtu"), series.specimen, std::move(frame), breakup.last, moment);
        progress.update(static_cast<double>(i + 1) / static_cast<double>(n), fmt::format("frame {}", i + 1));
    }
    progress.finish();
    return breakup;
}

Cell mode_cell(const Crack& crack, const CrackLabel& label) {
    const std::optional<CrackMode> mode = mode_of(crack, label);
    return mode ? Cell(*mode == CrackMode::tensile ? "tensile" : "shear") : Cell();
}

/// The events of a run by its window, made of the micro-cracks of its contact law.
std::vector<EmissionEvent> emission_of(const RunReader& run, const Specimen& specimen, const EventOptions& options) {
    EmissionWindow window = default_window(run.header().rock, specimen.statistics.mean_edge);
    window.distance = options.distance.value_or(window.distance);
    window.time = options.time.value_or(window.time);
    return find_events(read_labelled_cracks(run, specimen), run.header().rock, window);
}

}  // namespace

void write_crack_table(std::ostream& out, const std::vector<Crack>& log, const Specimen& specimen, TableFormat format) {
    using namespace unit;
    const ContactClasses classes = classes_of(specimen);
    const bool has_classes = contact_class_names(specimen).size() > 1;
    Columns<Crack> columns{{"time", second, [](const Crack& c) { return c.time; }},
                           {"step", none, [](const Crack& c) { return c.step; }},
                           {"contact", none, [](const Crack& c) { return c.contact; }},
                           {"point", none, [](const Crack& c) { return static_cast<int>(c.point); }},
                           {"mode", none, [](const Crack& c) { return mode_cell(c, {}); }},
                           {"mode_angle", radian, [](const Crack& c) { return c.mode_angle; }},
                           {"x", metre, [](const Crack& c) { return c.position[0]; }},
                           {"y", metre, [](const Crack& c) { return c.position[1]; }},
                           {"orientation", radian, [](const Crack& c) { return c.orientation; }},
                           {"length", metre, [](const Crack& c) { return c.length; }},
                           {"opening", metre, [](const Crack& c) { return c.opening; }},
                           {"sliding", metre, [](const Crack& c) { return c.sliding; }},
                           {"energy_released", joule, [](const Crack& c) { return c.energy_released; }}};
    const auto add = [&](const std::string& ending, CrackMoment Crack::*moment) {
        columns.push_back({"time" + ending, second, [moment](const Crack& c) { return (c.*moment).time; }});
        columns.push_back({"opening" + ending, metre, [moment](const Crack& c) { return (c.*moment).opening; }});
        columns.push_back({"sliding" + ending, metre, [moment](const Crack& c) { return (c.*moment).sliding; }});
    };
    add("_damaged_10", &Crack::damaged_10);
    add("_damaged_50", &Crack::damaged_50);
    add("_broken", &Crack::broken);
    add("_separated", &Crack::separated);
    constexpr std::array names{"mode_by_sign", "mode_damaged_50_by_sign", "mode_broken_by_sign"};
    static_assert(names.size() == all_crack_events.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        columns.push_back({names[i], none, [i](const Crack& c) {
                               return mode_cell(c, {all_crack_events[i], CrackModeRule::sign});
                           }});
    }
    columns.push_back({"class", none, [&](const Crack& c) { return has_classes ? Cell(classes.name_of(c)) : Cell(); }});
    write_table(out, columns, log, format);
}

void export_cracks(const RunReader& run, const std::string& folder, const CrackExportOptions& options, Verbosity verbosity) {
    const std::vector<double> all_times = run.frame_times();
    if (all_times.empty()) throw InputError(run.name() + ": has no frames; run the solver with --frames 1 or more");
    const Specimen specimen = run.specimen();
    const CrackLabel label = options.label.of(run.header());
    const std::vector<Crack> shown = labelled(read_cracks(run, specimen), label);
    const RunData data = run_data(run);
    const std::optional<LoadCurve> curve = load_curve_if_any(data);
    const std::vector<std::size_t> frames = distinct_frames(all_times);
    std::vector<double> times;
    for (const std::size_t frame : frames) times.push_back(all_times[frame]);
    make_folder(folder);
    const OutputLock lock(folder + "/cracks");
    // The lists of files come last: a folder without them is not whole.
    for (const char* list : {"/grains.pvd", "/cracks.pvd"}) remove_file(folder + list);
    const Series series{run, specimen, data, shown, label, folder, read_platen_faces(run.file(), specimen)};
    const Breakup breakup = write_frames(series, frames, verbosity);
    const std::vector<EmissionEvent> events = emission_of(run, specimen, options.events);
    const std::vector<Crack> log = read_cracks(run, specimen);
    const TableFormat format = options.format;
    const std::string ending = format == TableFormat::tsv ? ".tsv" : format == TableFormat::jsonl ? ".jsonl" : ".txt";
    const auto table = [&](const char* name, const auto& write) { write_table(folder + "/" + name + ending, write); };
    table("cracks", [&](std::ostream& out) { write_crack_table(out, log, specimen, format); });
    table("rosette", [&](std::ostream& out) { write_rosette(out, crack_rosette(shown, specimen), format); });
    table("events", [&](std::ostream& out) { write_events(out, events, format); });
    table("fragments", [&](std::ostream& out) { write_fragments(out, breakup.last, format); });
    if (!breakup.crystals.empty()) table("crystals", [&](std::ostream& out) { write_crystals(out, breakup.crystals, format); });
    table("summary", [&](std::ostream& out) {
        write_crack_summary(out, data, curve, {log, specimen, label}, events, breakup.last, format);
    });
    const std::optional<double> peak = curve ? std::optional(data.history[HistoryColumn::time][curve->peak]) : std::nullopt;
    const std::vector<RunClasses> classes{classes_of_run(data.name, specimen, shown, label, peak)};
    table("classes", [&](std::ostream& out) { write_class_counts(out, classes, format); });
    std::vector<Part> blocks{{"grains", "vtu"}};
    if (series.has_platens()) blocks.push_back({"platens", "vtp"});
    OutputFile grains_list(folder + "/grains.pvd");
    OutputFile cracks_list(folder + "/cracks.pvd");
    grains_list.begin();
    cracks_list.begin();
    grains_list.write(pvd(blocks, times));
    cracks_list.write(pvd({{"cracks", "vtp"}}, times));
    grains_list.commit();
    cracks_list.commit();
    add_output_to_outcome(folder);
}

void add_crack_label(OptionSet set, CrackLabelChoice& label) {
    std::vector<std::pair<std::string, std::optional<CrackEvent>>> events;
    for (const CrackEvent event : all_crack_events) events.emplace_back(name_of(event), event);
    add_choice<std::optional<CrackEvent>>(
        set.seldom(), "--crack-event", label.event, events,
        "when a contact point counts as a micro-crack: it reached its strength (failed), less than "
        "50 % (half-damaged) or less than 10 % (broken) of its cohesion is left; default: "
        "half-damaged for laws with friction in addition to cohesion, failed for others");
    add_choice<CrackModeRule>(set.seldom(), "--crack-mode", label.mode,
                              {{"traction", CrackModeRule::traction}, {"sign", CrackModeRule::sign}},
                              "when a micro-crack is tensile: it was open and under more tension than shear when it failed "
                              "(traction), or it was open at the event (sign)");
}

}  // namespace graincrack
