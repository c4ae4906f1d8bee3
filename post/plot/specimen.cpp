#include "post/plot/specimen.hpp"

#include <fmt/format.h>

#include <numbers>

#include "post/chart/map_view.hpp"
#include "post/plot/make_plot.hpp"
#include "share/h5_file.hpp"
#include "share/units.hpp"

namespace graincrack {

namespace {

ChartText heading(const Specimen& specimen) {
    const MeshStatistics& mesh = specimen.statistics;
    const bool disc = specimen.shape == "disc";
    const std::string size = disc ? "⌀ " + format_number(specimen.width * 1e3, 4)
                                  : format_number(specimen.width * 1e3, 4) + " × " + format_number(specimen.height * 1e3, 4);
    std::string shape = specimen.shape;
    if (!shape.empty() && shape[0] >= 'a' && shape[0] <= 'z') shape[0] = static_cast<char>(shape[0] - 'a' + 'A');
    return {fmt::format("{} {} mm, {} grains", shape, size, specimen.n_grains()),
            {fmt::format("{}, seed {}: mean edge {:.4g} mm, variation {:.3g}", specimen.tessellation, specimen.seed,
                         mesh.mean_edge * 1e3, mesh.edge_variation),
             fmt::format("smallest angle {:.3g}°, preferred direction ψ6 {:.2g}", mesh.min_angle * 180 / std::numbers::pi,
                         mesh.psi6)}};
}

}  // namespace

Drawing draw_specimen(const Specimen& specimen, const PictureStyle& style) {
    MapView map(specimen, specimen.node_position, heading(specimen), {style});
    map.draw_grains();
    const bool cracked = map.draw_pre_existing_cracks(4);
    std::vector<LegendEntry> legend;
    if (specimen.phase_names.size() > 1) {
        for (std::size_t i = 0; i < specimen.phase_names.size(); ++i)
            legend.push_back({palette::phase(i), specimen.phase_names[i]});
    }
    if (cracked) legend.push_back({Stroke{palette::pre_existing, 4}, "pre-existing crack"});
    map.draw_legend(legend);
    return std::move(map).drawing();
}

Command specimen_plot() {
    return make_plot<PlotOptions>("specimen", "the grains of a specimen", {"disc.h5 -o disc.png", "uniaxial.h5 -o specimen.svg"},
                                  FileArguments{"file", "specimen or run"}, add_picture,
                                  [](const PlotOptions& options, const Call& call) {
                                      return draw_specimen(read_specimen(H5Input(call.file())), options.style);
                                  });
}

}  // namespace graincrack
