#include "post/plot/cracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "post/chart/map_view.hpp"
#include "post/cracks/run_state.hpp"
#include "post/measure/load_curve.hpp"
#include "post/measure/objections.hpp"
#include "post/measure/test_label.hpp"
#include "share/command_line.hpp"

namespace graincrack {

namespace {

/// Strain and stress of the test at the time of the frame; also the platens' approach for drawing them.
struct Standing {
    double strain = 0;        ///< positive in the sense of the test
    double stress = 0;        ///< Pa
    double share = 0;         ///< of the peak
    bool before = false;      ///< the peak
    double axial_strain = 0;  ///< elongation positive
    std::string peak;         ///< what the largest stress is called
    [[nodiscard]] bool at_peak() const { return share > 0.9995; }
    [[nodiscard]] std::string share_label() const {
        if (at_peak()) return peak;
        return fmt::format("{}, {:.0f} %", before ? "before" : "after", 100 * share);
    }
};

Standing standing(const RunData& run, const LoadCurve& curve, double time) {
    const auto& times = run.history[HistoryColumn::time];
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    const auto row = static_cast<std::size_t>(std::min(after, times.end() - 1) - times.begin());
    return {curve.axial_strain[row],
            curve.stress[row],
            curve.stress[row] / curve.peak_stress(),
            row < curve.peak,
            run.history[HistoryColumn::axial_strain][row],
            peak_label(run)};
}

std::string standing_label(const Standing& now, bool disc, double magnification) {
    std::string label = fmt::format("strain {:.3f} %, {} {:.1f} MPa ({})", 100 * now.strain, disc ? "2F/(πtD)" : "stress",
                                    now.stress * 1e-6, now.at_peak() ? now.peak : now.share_label() + " of the " + now.peak);
    if (magnification != 1) label += fmt::format("; displacements × {:.3g}", magnification);
    return label;
}

/// Draws the half facet of a failed contact point: one line midway between its two sides, or, where the crack is open, one on
/// each.
void draw_crack(MapView& map, const Specimen& specimen, const Crack& crack, double width) {
    const auto& nodes = specimen.contact_nodes[static_cast<std::size_t>(crack.contact)];
    const auto at = [&](std::size_t k) { return map.positions()[static_cast<std::size_t>(nodes[k])]; };
    const auto between = [](std::array<double, 2> p, std::array<double, 2> q) {
        return std::array{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
    };
    const Colour colour = crack.mode == CrackMode::tensile ? palette::tensile : palette::shear;
    const auto draw = [&](std::array<double, 2> first, std::array<double, 2> second, double stroke) {
        const auto middle = between(first, second);
        map.stroke(crack.point == 0 ? first : middle, crack.point == 0 ? middle : second, stroke, colour);
    };
    const std::size_t end = crack.point;  // a1, b1 or a2, b2
    const auto side_a = at(end);
    const auto side_b = at(end + 2);
    const double gap = std::hypot(side_a[0] - side_b[0], side_a[1] - side_b[1]) * map.pixels_per_metre();
    if (gap <= 2 * width) {
        draw(between(at(0), at(2)), between(at(1), at(3)), width);
    } else {
        draw(at(0), at(1), 0.7 * width);
        draw(at(2), at(3), 0.7 * width);
    }
}

std::string contacts_of(std::size_t points) { return whole_contacts(0.5 * static_cast<double>(points)); }

/// What all maps of a picture have in common.
struct Scene {
    const RunReader& run;
    const Specimen& specimen;
    std::vector<Crack> cracks;
    RunData data;
    const CrackMapOptions& options;
    std::vector<std::string> objections = {};  ///< what speaks against the strength, a line each
};

std::size_t count(const std::vector<Crack>& cracks, CrackMode mode) {
    return static_cast<std::size_t>(
        std::count_if(cracks.begin(), cracks.end(), [mode](const Crack& c) { return c.mode == mode; }));
}

/// Grains, platens and cracks of one frame. \return whether there are cracks from before the test
bool draw_state(MapView& map, const Scene& scene, const Standing& now, const std::vector<Crack>& present) {
    const Specimen& specimen = scene.specimen;
    map.draw_grains();
    if (scene.data.header.test != "tension") {
        const double y = specimen.height / 2 * (1 + scene.options.magnification * now.axial_strain);
        const double half_width = specimen.width / 2 * (specimen.shape == "disc" ? 0.5 : 1.0);
        map.draw_platen(y, true, half_width);
        map.draw_platen(-y, false, half_width);
    }
    const double edge = specimen.statistics.mean_edge * map.pixels_per_metre();
    const double width = edge > 0 ? std::clamp(0.1 * edge, 1.2, 6.0) : 4.0;
    const bool cracked_before = map.draw_pre_existing_cracks(width);
    for (const CrackMode mode : {CrackMode::shear, CrackMode::tensile}) {
        for (const Crack& crack : present) {
            if (crack.mode == mode) draw_crack(map, specimen, crack, width);
        }
    }
    return cracked_before;
}

/// What a map shows of a frame; the frame itself is released.
struct Snapshot {
    double time;
    Positions places;
};

Snapshot snapshot(const Scene& scene, std::size_t index) {
    const Frame frame = read_frame(scene.run, scene.specimen, index);
    return {frame.time, moved_nodes(scene.specimen, frame, scene.options.magnification)};
}

Drawing single_map(const Scene& scene, Snapshot shot) {
    const RunHeader& header = scene.data.header;
    const std::vector<Crack> present = cracks_until(scene.cracks, shot.time);
    const Standing now = standing(scene.data, load_curve(scene.data), shot.time);
    const Specimen& specimen = scene.specimen;
    std::vector<std::string> title{test_title(header),
                                   fmt::format("seed {}, {} grains, mean edge {:.3g} mm, plane {}", specimen.seed,
                                               specimen.n_grains(), specimen.statistics.mean_edge * 1e3, name_of(header.plane)),
                                   fmt::format("law {}, {}", header.contact_law, header.fracture_energy_choice),
                                   standing_label(now, header.test == "brazilian", scene.options.magnification)};
    title.insert(title.end(), scene.objections.begin(), scene.objections.end());
    MapView map(specimen, std::move(shot.places), title);
    std::vector<LegendEntry> legend{{palette::tensile, 6, "tensile cracks: " + contacts_of(count(present, CrackMode::tensile))},
                                    {palette::shear, 6, "shear cracks: " + contacts_of(count(present, CrackMode::shear))}};
    if (draw_state(map, scene, now, present)) legend.push_back({palette::pre_existing, 6, "pre-existing"});
    map.draw_legend(legend, definition_of(scene.options.label));
    return std::move(map).drawing();
}

Drawing panel(const Scene& scene, Snapshot shot, double width, char letter) {
    const std::vector<Crack> present = cracks_until(scene.cracks, shot.time);
    const Standing now = standing(scene.data, load_curve(scene.data), shot.time);
    MapPage page{width, 1000, 14, 27, 23, 0};
    MapView map(scene.specimen, std::move(shot.places),
                {fmt::format("({}) {}", letter, now.share_label()),
                 fmt::format("{:.3f} %, {:.1f} MPa", 100 * now.strain, now.stress * 1e-6),
                 fmt::format("tensile {}, shear {}", contacts_of(count(present, CrackMode::tensile)),
                             contacts_of(count(present, CrackMode::shear)))},
                page);
    draw_state(map, scene, now, present);
    return std::move(map).drawing();
}

/// Maps side by side under one title.
Drawing panels(const Scene& scene, const std::vector<std::size_t>& frames) {
    constexpr double page_width = 1000;
    constexpr double line = 34;
    std::vector<std::string> lines{fmt::format("plane {}", name_of(scene.data.header.plane))};
    lines.insert(lines.end(), scene.objections.begin(), scene.objections.end());
    const double head = 60 + line * static_cast<double>(lines.size());
    constexpr double foot = 50;
    const double width = page_width / static_cast<double>(frames.size());
    Drawing page(static_cast<int>(page_width), 0);
    page.text({{26, 44}, test_title(scene.data.header), 31, palette::ink, Anchor::start, true});
    for (std::size_t i = 0; i < lines.size(); ++i) {
        page.text({{26, 44 + line * static_cast<double>(i + 1)}, lines[i], 25});
    }
    int height = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Drawing map = panel(scene, snapshot(scene, frames[i]), width, static_cast<char>('a' + i));
        page.add(map, {width * static_cast<double>(i), head});
        height = std::max(height, map.height());
    }
    const double y = head + height + 20;
    page.line({26, y - 8}, {70, y - 8}, 6, palette::tensile);
    page.text({{84, y}, "tensile cracks", 25});
    page.line({330, y - 8}, {374, y - 8}, 6, palette::shear);
    page.text({{388, y}, "shear cracks (counts are contacts)", 25});
    page.text({{26, y + 34}, definition_of(scene.options.label), 25});
    page.set_height(static_cast<int>(y + 34 + foot / 2));
    return page;
}

}  // namespace

Drawing draw_cracks(const RunReader& run, const CrackMapOptions& options) {
    const std::vector<std::size_t> frames = choose_frames(run, options.frame, options.time);
    const Specimen specimen = run.specimen();
    Scene scene{run, specimen, read_labelled_cracks(run, specimen, options.label), run_data(run), options};
    for (const Objection& objection : objections_to(run, scene.data)) scene.objections.push_back(subtitle_line(objection));
    if (frames.size() == 1) return single_map(scene, snapshot(scene, frames[0]));
    return panels(scene, frames);
}

void add_map_options(CLI::App& app, MapPlotOptions& options) {
    constexpr Quantity frame_time{"time", Dimension::time, 0, std::numeric_limits<double>::infinity(), "simulated time"};
    constexpr Quantity magnification{"magnify", Dimension::one, 0, 1e6, "factor on displacements"};
    add_picture(app, options);
    app.add_option("--frame", options.map.frame,
                   "frame: first, before, peak, after (80 % of the peak on that side), last or a number from 0; for cracks "
                   "several with commas stand side by side, once where they mean the same")
        ->capture_default_str();
    add_quantity(app, "--time", options.map.time, frame_time, "frame nearest to a simulated time");
    add_quantity(app, "--magnify", options.map.magnification, magnification, "draw displacements so many times as large", "1");
}

Command cracks_plot() {
    return make_plot<MapPlotOptions>(
        "cracks", "crack map: tensile red, shear black",
        {"brazilian.h5 --frame before,peak,after -o cracks.png", "uniaxial.h5 --magnify 10 --crack-event broken -o cracks.svg"},
        one_run,
        [](CLI::App& app, MapPlotOptions& options) {
            add_map_options(app, options);
            add_crack_label(app, options.map.label);
        },
        [](const MapPlotOptions& options, const Call& call) { return draw_cracks(RunReader(call.file()), options.map); });
}

}  // namespace graincrack
