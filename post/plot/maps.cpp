// Draws maps of a specimen with its grains and cracks.
#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "post/chart/map_view.hpp"
#include "post/chart/picture_folder.hpp"
#include "post/measure/caveats.hpp"
#include "post/run/crystals.hpp"
#include "post/run/load_curve.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/base/progress.hpp"
#include "share/base/units.hpp"
#include "share/file/platen_faces.hpp"
#include "share/file/specimen_measures.hpp"

namespace graincrack {

namespace {

/// Strain and stress of the test at the time of a frame, and the approach of the platens.
struct Standing {
    double strain = 0;        ///< positive in the sense of the test
    double stress = 0;        ///< Pa
    double share = 0;         ///< stress over that at the peak
    bool before = false;      ///< true before the peak
    double axial_strain = 0;  ///< elongation positive
    std::string peak;         ///< name of the stress at the peak
    /// \param of text after the fraction
    [[nodiscard]] std::string share_label(const std::string& of = "") const {
        if (share > 0.9995) return peak;
        if (before && std::abs(share) < 0.0005) return "before loading";
        return fmt::format("{}, {:.0f} %{}", before ? "before" : "after", std::round(100 * share) + 0.0, of);  // no "-0"
    }
};

Standing standing(const RunData& run, const LoadCurve& curve, double time) {
    const std::size_t row = row_at(run.history, time);
    return {curve.axial_strain[row],
            curve.shown_stress(row),
            curve.shown_stress(row) / curve.peak_stress(),
            row < curve.peak,
            run.history[HistoryColumn::axial_strain][row],
            curve.peak_name()};
}

/// \param stress name of the stress
std::string standing_label(const Standing& now, const std::string& stress, double magnification) {
    std::string label =
        fmt::format("strain {:.3f} %, {} {:.1f} MPa ({})", 100 * now.strain, stress == "axial stress" ? "stress" : stress,
                    now.stress * 1e-6, now.share_label(" of the " + now.peak));
    if (magnification != 1) label += fmt::format("; displacements × {:.3g}", magnification);
    return label;
}

/// The data that all maps of a run have in common.
struct Scene {
    const RunReader& run;
    const CrackMapOptions& options;
    const PictureStyle& style;
    Specimen specimen = run.specimen();
    std::vector<Crack> cracks = read_labelled_cracks(run, specimen, options.label);
    RunData data = run_data(run);
    LoadCurve curve = load_curve(data);
    /// Notes below the maps: the definition of the cracks, and the caveats of the strength.
    std::vector<std::string> notes = crack_notes(specimen, options.label.of(data.header));
    Scene(const RunReader& of, const CrackMapOptions& by, const PictureStyle& in) : run(of), options(by), style(in) {
        for (const Caveat& caveat : caveats_of(run, data)) notes.push_back(note_line(caveat));
    }
    [[nodiscard]] Standing at(double time) const { return standing(data, curve, time); }
};

/// Legend of cracks by mode, older cracks and phases. \param tensile text after the words for tensile cracks
std::vector<LegendEntry> crack_legend(const Scene& scene, const std::string& tensile, const std::string& shear) {
    std::vector<LegendEntry> legend{{Stroke{palette::tensile, 6}, "tensile cracks" + tensile},
                                    {Stroke{palette::shear, 6}, "shear cracks" + shear}};
    if (has_pre_existing_cracks(scene.specimen)) legend.push_back({Stroke{palette::pre_existing, 6}, "pre-existing"});
    if (scene.options.fill != MapFill::mineral) return legend;
    for (LegendEntry& phase : phase_legend(scene.specimen)) legend.push_back(std::move(phase));
    return legend;
}

const char* label_of(MapFill fill) {
    return fill == MapFill::sigma1   ? "greatest compression σ1 in the plane, MPa"
           : fill == MapFill::sigma3 ? "least compression σ3 in the plane (tension below 0), MPa"
                                     : "displacement, mm";
}

/// Values of the elements in the unit of `label_of`; none for minerals.
std::vector<double> values_of(const Specimen& specimen, const Frame& frame, MapFill fill) {
    std::vector<double> values;
    for (std::size_t e = 0; fill != MapFill::mineral && e < specimen.n_elements(); ++e) {
        const auto& [xx, yy, xy, zz] = frame.element_stress[e];
        const double radius = std::hypot((xx - yy) / 2, xy);
        std::array<double, 2> sum{};
        for (const std::int32_t node : specimen.element_nodes[e]) {
            for (std::size_t axis = 0; axis < 2; ++axis) sum[axis] += frame.displacement[static_cast<std::size_t>(node)][axis];
        }
        values.push_back(fill == MapFill::displacement
                             ? 1e3 * std::hypot(sum[0], sum[1]) / 3
                             : in_megapascals * ((fill == MapFill::sigma1 ? radius : -radius) - (xx + yy) / 2));
    }
    return values;
}

/// The part of a frame that a map shows; the rest is released.
struct Snapshot {
    double time;
    Positions places;
    std::vector<double> values;
};

Snapshot snapshot(const Scene& scene, std::size_t index) {
    const Frame frame = read_frame(scene.run, scene.specimen, index);
    return {frame.time, moved_nodes(scene.specimen, frame, scene.options.magnification),
            values_of(scene.specimen, frame, scene.options.fill)};
}

void draw_state(MapView& map, const Scene& scene, const Snapshot& shot, const std::vector<Crack>& present) {
    map.draw_grains(shot.values);
    if (has_platens_to_draw(scene.data)) {
        const double approach = -scene.options.magnification * scene.at(shot.time).axial_strain * scene.specimen.height / 2;
        map.draw_platens(read_platen_faces(scene.run.file(), scene.specimen), approach);
    }
    draw_cracks(map, scene.specimen, present);
}

ChartText heading_at(const Scene& scene, double time) {
    const RunHeader& header = scene.data.header;
    const Specimen& specimen = scene.specimen;
    return {scene.style.title.empty() ? test_title(header) : scene.style.title,
            {fmt::format("seed {}, {}, mean edge {:.3g} mm, plane {}", specimen.seed, grains_label(specimen),
                         specimen.statistics.mean_edge * 1e3, name_of(header.plane)),
             "law " + header.contact_law +
                 (header.fracture_energy_choice == "value" ? "" : ", fracture energy " + header.fracture_energy_choice),
             standing_label(scene.at(time), stress_name(scene.data), scene.options.magnification)}};
}

Drawing single_map(const Scene& scene, Snapshot shot, const MapPage& page) {
    const std::vector<Crack> present = cracks_until(scene.cracks, shot.time);
    MapView map(scene.specimen, std::move(shot.places), heading_at(scene, shot.time), page);
    draw_state(map, scene, shot, present);
    map.draw_legend(crack_legend(scene, ": " + cracked_contacts(present, CrackMode::tensile),
                                 ": " + cracked_contacts(present, CrackMode::shear)),
                    scene.notes);
    return std::move(map).drawing();
}

/// The caption above one of several maps.
ChartText caption(const Scene& scene, double time, char letter) {
    const std::vector<Crack> present = cracks_until(scene.cracks, time);
    const Standing now = scene.at(time);
    const auto plus = [](double value) { return std::abs(value) < 0.0005 ? 0.0 : value; };  // no "−0.000"
    return {
        fmt::format("({}) {}", letter, now.share_label()),
        {fmt::format("strain {:.3f} %", plus(100 * now.strain)), fmt::format("stress {:.1f} MPa", plus(now.stress * 1e-6)),
         "tensile: " + cracked_contacts(present, CrackMode::tensile), "shear: " + cracked_contacts(present, CrackMode::shear)}};
}

/// Number of maps side by side that leaves room for their captions and fills the rows about evenly.
std::size_t maps_in_a_row(std::size_t maps, double page_width) {
    constexpr double room = 245;  // for a caption, pixels
    const std::size_t most = std::max<std::size_t>(1, static_cast<std::size_t>(page_width / room));
    const std::size_t rows = (maps + most - 1) / most;
    return (maps + rows - 1) / rows;
}

/// A row of maps with captions of equal height. \param letter of the first \param scale receives the scale of the maps
Drawing row_of_maps(const Scene& scene, std::span<const std::size_t> frames, char letter, MapPage page, MapScale& scale) {
    const std::vector<double> times = scene.run.frame_times();
    const TextColumn column{page.margin, page.style.page_width - page.margin};
    const auto text = [&](std::size_t i) { return caption(scene, times[frames[i]], static_cast<char>(letter + i)); };
    for (std::size_t i = 0; i < frames.size(); ++i) {
        page.heading_height = std::max(page.heading_height, heading_height(text(i), column));
    }
    std::vector<Drawing> maps;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        Snapshot shot = snapshot(scene, frames[i]);
        MapView map(scene.specimen, std::move(shot.places), text(i), page);
        draw_state(map, scene, shot, cracks_until(scene.cracks, shot.time));
        scale = map.scale();
        maps.push_back(std::move(map).drawing());
    }
    return side_by_side(maps);
}

/// A page for maps of several frames at one scale, with a box that holds all of them and common colours for their values.
MapPage common_page(const Scene& scene, const std::vector<std::size_t>& frames, MapPage page) {
    MapBox view;
    ColourScale colours{label_of(scene.options.fill)};
    for (const std::size_t frame : frames) {
        Snapshot shot = snapshot(scene, frame);
        view.include(view_box(scene.specimen, shot.places));
        colours.include(std::move(shot.values));
    }
    page.view = view;
    if (scene.options.fill != MapFill::mineral) page.colours = colours;
    return page;
}

/// Maps of one scale side by side under one title.
Drawing panels(const Scene& scene, const std::vector<std::size_t>& frames) {
    const double page_width = scene.style.page_width;
    const std::size_t in_a_row = maps_in_a_row(frames.size(), page_width);
    const TextColumn column{page_margin, page_width - page_margin};
    ChartText text{scene.style.title.empty() ? test_title(scene.data.header) : scene.style.title,
                   {fmt::format("plane {}", name_of(scene.data.header.plane))}};
    const double width = std::floor(page_width / static_cast<double>(in_a_row));
    const MapPage part = common_page(scene, frames, {scene.style.of_part(width), page_width, 10});
    MapScale scale;
    Drawing page(static_cast<int>(page_width), 0);
    page.set_height(draw_heading(page, text, column, 14));
    for (std::size_t first = 0; first < frames.size(); first += in_a_row) {
        const auto row = std::span(frames).subspan(first, std::min(in_a_row, frames.size() - first));
        page = stacked({page, row_of_maps(scene, row, static_cast<char>('a' + first), part, scale)});
    }
    double top = page.height() + 6;
    if (part.colours) top = part.colours->draw(page, column, top);
    const LegendEnd end = draw_legend(page, crack_legend(scene, "", " (counts are contacts)"), column, top);
    const double bottom = draw_scale_bar(page, scale, column, end);
    page.set_height(draw_heading(page, {"", scene.notes}, column, bottom) + 14);
    return page;
}

}  // namespace

Drawing draw_cracks(const RunReader& run, const CrackMapOptions& options, const PictureStyle& style) {
    const std::vector<std::size_t> frames = choose_frames(run, options.frame, options.time);
    const Scene scene(run, options, style);
    if (frames.size() > 1) return panels(scene, frames);
    return single_map(scene, snapshot(scene, frames[0]), common_page(scene, frames, {style, options.largest_height}));
}

void write_frames(const RunReader& run, const CrackMapOptions& options, const PictureStyle& style, const std::string& folder,
                  const PictureSize& size, Verbosity verbosity) {
    if (folder == "-" || std::filesystem::path(folder).has_extension()) {
        throw UsageError("--output " + folder + ": --frame all writes numbered pictures; the name of a folder fits");
    }
    std::vector<std::size_t> frames(choose_frame(run, "last", std::nullopt) + 1);
    std::iota(frames.begin(), frames.end(), 0);
    const Scene scene(run, options, style);
    MapPage page = common_page(scene, frames, {style, options.largest_height});
    const TextColumn column{page.margin, style.page_width - page.margin};
    for (const double time : run.frame_times()) {
        page.heading_height = std::max(page.heading_height, heading_height(heading_at(scene, time), column));
    }
    // The last frame has the most cracks, and thus the longest legend.
    const double height = single_map(scene, snapshot(scene, frames.back()), page).height();
    Progress progress("plot cracks", verbosity);
    write_picture_folder(folder, frames.size(), [&](std::size_t frame) {
        Drawing drawing = single_map(scene, snapshot(scene, frame), page);
        drawing.set_height(height);
        progress.update(static_cast<double>(frame + 1) / static_cast<double>(frames.size()), fmt::format("frame {}", frame));
        return png_bytes(drawing, size);
    });
}

namespace {

ChartText specimen_heading(const Specimen& specimen) {
    const MeshStatistics& mesh = specimen.statistics;
    const bool is_round = !has_end_faces(specimen) && specimen.shape != "polygon";
    const std::string size = is_round ? "⌀ " + format_number(specimen.width * 1e3, 4)
                                      : format_number(specimen.width * 1e3, 4) + " × " + format_number(specimen.height * 1e3, 4);
    std::string shape = specimen.shape;
    if (!shape.empty() && shape[0] >= 'a' && shape[0] <= 'z') shape[0] = static_cast<char>(shape[0] - 'a' + 'A');
    return {fmt::format("{} {} mm, {}", shape, size, grains_label(specimen)),
            {fmt::format("{}, seed {}: mean edge {:.4g} mm, variation {:.3g}", specimen.tessellation, specimen.seed,
                         mesh.mean_edge * 1e3, mesh.edge_variation),
             fmt::format("smallest angle {:.3g}°, preferred direction ψ6 {:.2g}", mesh.min_angle * 180 / std::numbers::pi,
                         mesh.psi6)}};
}

}  // namespace

Drawing draw_specimen(const Specimen& specimen, const PictureStyle& style) {
    MapView map(specimen, specimen.node_position, specimen_heading(specimen), {style});
    map.draw_grains();
    std::vector<LegendEntry> legend = phase_legend(specimen);
    if (map.draw_flaws(2.5, false)) legend.push_back({Stroke{palette::intact_flaw, 2.5}, "intact joint"});
    if (map.draw_flaws(4, true)) legend.push_back({Stroke{palette::pre_existing, 4}, "pre-existing crack"});
    map.draw_legend(legend);
    return std::move(map).drawing();
}

}  // namespace graincrack
