#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numbers>

#include "post/chart/map_view.hpp"
#include "post/run/crystals.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"
#include "share/file/end_faces.hpp"
#include "share/file/h5_file.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

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

/// Lower ends of the steps of strength factors, whose mean is 1, and their colours: even steps of viridis (van der Walt & Smith
/// 2015), the weaker the darker, so that they stay apart in grey and for colour-blind eyes.
struct StrengthStep {
    double from;
    Colour colour;
    const char* label;
};
constexpr std::array<StrengthStep, 5> strength_steps{{{0, {68, 1, 84}, "< 0.5"},
                                                      {0.5, {59, 82, 139}, "0.5 to 0.75"},
                                                      {0.75, {33, 145, 140}, "0.75 to 1"},
                                                      {1, {94, 201, 98}, "1 to 1.25"},
                                                      {1.25, {253, 231, 37}, "> 1.25"}}};

/// Contacts as strokes, the weaker the darker and the later drawn.
void draw_strengths(MapView& map, const Specimen& specimen, const std::string& file, std::vector<LegendEntry>& legend) {
    const std::vector<double>& factors = specimen.contact_strength_factor;
    if (factors.empty()) {
        throw InputError(file + ": its contacts have no strength factors; graincrack-mesh --strength-modulus gives them");
    }
    map.draw_grains([](std::size_t /*grain*/) { return palette::white; });
    const double width = std::clamp(0.12 * specimen.statistics.mean_edge * map.pixels_per_metre(), 1.2, 6.0);
    for (auto step = strength_steps.rbegin(); step != strength_steps.rend(); ++step) {
        const double to = step == strength_steps.rbegin() ? std::numeric_limits<double>::infinity() : std::prev(step)->from;
        for (std::size_t c = 0; c < factors.size(); ++c) {
            if (factors[c] < step->from || factors[c] >= to) continue;
            const auto at = [&](std::size_t k) {
                return map.positions()[static_cast<std::size_t>(specimen.contact_nodes[c][k])];
            };
            map.stroke(at(0), at(1), width, step->colour);
        }
    }
    for (const StrengthStep& step : strength_steps) {
        legend.push_back({Stroke{step.colour, 6}, (legend.empty() ? "strength factor " : "") + std::string(step.label)});
    }
}

}  // namespace

Drawing draw_specimen(const Specimen& specimen, const std::string& file, SpecimenColour colour, const PictureStyle& style) {
    MapView map(specimen, specimen.node_position, specimen_heading(specimen), {style});
    std::vector<LegendEntry> legend;
    if (colour == SpecimenColour::strength) {
        draw_strengths(map, specimen, file, legend);
    } else {
        map.draw_grains();
        legend = phase_legend(specimen);
    }
    if (map.draw_pre_existing_cracks(4)) legend.push_back({Stroke{palette::pre_existing, 4}, "pre-existing crack"});
    map.draw_legend(legend);
    return std::move(map).drawing();
}

Command specimen_plot() {
    struct Options : PlotOptions {
        SpecimenColour colour = SpecimenColour::phase;
    };
    return make_plot<Options>(
        "specimen", "the grains of a specimen", {"disc.h5 -o disc.png", "uniaxial.h5 -o specimen.svg"},
        FileArguments{"file", "specimen or run"},
        [](OptionSet set, Options& options) {
            add_picture(set, options);
            add_choice<SpecimenColour>(set, "--colour", options.colour,
                                       {{"phase", SpecimenColour::phase}, {"strength", SpecimenColour::strength}},
                                       "grains by their phase (mineral), or contacts by the factor on their strengths");
        },
        [](const Options& options, const Call& call) {
            const H5Input file(call.file());
            return draw_specimen(read_specimen(file), file.name(), options.colour, options.style);
        });
}

}  // namespace graincrack
