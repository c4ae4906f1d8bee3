#include "post/picture/plot_cracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/cracks/run_state.hpp"
#include "post/load_curve.hpp"
#include "post/picture/map_view.hpp"
#include "post/test_words.hpp"

namespace graincrack {

namespace {

Positions moved(const Specimen& specimen, const Frame& frame, double magnification) {
    Positions places = specimen.node_position;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i][0] += magnification * frame.displacement[i][0];
        places[i][1] += magnification * frame.displacement[i][1];
    }
    return places;
}

/// Where the test stands at the time of the frame; also the platens' approach for drawing them.
struct Standing {
    std::string words;
    double axial_strain = 0;  ///< elongation positive
};

Standing standing(const RunData& run, const Frame& frame, double magnification) {
    const LoadCurve curve = load_curve(run);
    const auto& times = run.history[HistoryColumn::time];
    const auto after = std::lower_bound(times.begin(), times.end(), frame.time);
    const auto row = static_cast<std::size_t>(std::min(after, times.end() - 1) - times.begin());
    const bool disc = run.header.test == "brazilian";
    std::string words = fmt::format("strain {:.3f} %, {} {:.1f} MPa", curve.axial_strain[row] * 100,
                                    disc ? "tensile stress 2F/(πtD)" : "axial stress", curve.stress[row] * 1e-6);
    if (curve.stress[row] > 0.9995 * curve.peak_stress()) {
        words += " (peak)";
    } else {
        words += fmt::format(" ({:.0f} % of the peak, {} it)", 100 * curve.stress[row] / curve.peak_stress(),
                             row < curve.peak ? "before" : "after");
    }
    if (magnification != 1) words += fmt::format("; displacements × {:.3g}", magnification);
    return {words, run.history[HistoryColumn::axial_strain][row]};
}

/// Draws the half facet of a failed contact point: one line midway between its two sides, or, where they gape, one on each.
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

/// Points ÷ 2: whole contacts.
std::string contacts_of(std::size_t points) { return fmt::format("{}", static_cast<double>(points) / 2); }

}  // namespace

Drawing draw_cracks(const RunReader& run, const CrackMapOptions& options) {
    const std::size_t index = choose_frame(run, options.frame, options.time);
    const Specimen specimen = run.specimen();
    const Frame frame = read_frame(run, specimen, index);
    const std::vector<Crack> cracks = cracks_until(read_cracks(run, specimen), frame.time);
    const Standing now = standing(run_data(run), frame, options.magnification);
    MapView map(specimen, moved(specimen, frame, options.magnification),
                {test_title(run.header()),
                 fmt::format("seed {}, {} grains, mean edge {:.3g} mm; contact law {}, {}", specimen.seed, specimen.n_grains(),
                             specimen.statistics.mean_edge * 1e3, run.header().contact_law, run.header().fracture_energy_choice),
                 now.words});
    map.draw_grains();
    if (run.header().test != "tension") {
        const double y = specimen.height / 2 * (1 + options.magnification * now.axial_strain);
        const double half_width = specimen.width / 2 * (specimen.shape == "disc" ? 0.5 : 1.0);
        map.draw_platen(y, true, half_width);
        map.draw_platen(-y, false, half_width);
    }
    const double edge = specimen.statistics.mean_edge * map.pixels_per_metre();
    const double width = edge > 0 ? std::clamp(0.1 * edge, 1.2, 6.0) : 4.0;
    std::size_t tensile = 0;
    for (const CrackMode mode : {CrackMode::shear, CrackMode::tensile}) {
        for (const Crack& crack : cracks) {
            if (crack.mode != mode) continue;
            draw_crack(map, specimen, crack, width);
            if (mode == CrackMode::tensile) ++tensile;
        }
    }
    map.draw_legend({{palette::tensile, 6, "tensile cracks: " + contacts_of(tensile)},
                     {palette::shear, 6, "shear cracks: " + contacts_of(cracks.size() - tensile)}});
    return map.drawing();
}

}  // namespace graincrack
