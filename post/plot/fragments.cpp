#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <array>

#include "post/chart/map_view.hpp"
#include "post/cracks/fragments.hpp"
#include "post/run/crystals.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"

namespace graincrack {

namespace {

/// Half-strong colours of the series, so that outlines stay visible.
Colour fragment_colour(std::size_t fragment) {
    if (fragment == 0) return palette::grain;
    const Colour c = palette::series(fragment - 1);
    const auto pale = [](std::uint8_t value) { return static_cast<std::uint8_t>(value + (255 - value) * 2 / 5); };
    return {pale(c.red), pale(c.green), pale(c.blue)};
}

}  // namespace

Drawing draw_fragments(const RunReader& run, const CrackMapOptions& options, const PictureStyle& style) {
    const Specimen specimen = run.specimen();
    Frame frame = read_frame(run, specimen, choose_frame(run, options.frame, options.time));
    const Fragments fragments = find_fragments(specimen, frame.state);
    const FragmentCount count = count_fragments(fragments, frame.time);
    MapView map(specimen, moved_nodes(specimen, frame, options.magnification),
                {test_title(run.header()),
                 {counted(count.fragments, "fragment") +
                      (count.single_grains > 0 ? ", of which " + counted(count.single_grains, "single grain") : ""),
                  fmt::format("the largest has {:.1f} % of the area; diameter {:.3g} mm", 100 * count.largest_share,
                              1e3 * fragments.all.front().diameter())}},
                {style});
    map.draw_grains([&](std::size_t grain) { return fragment_colour(fragments.of_grain[grain]); });
    constexpr double line = 5;
    const auto grains = grains_of_contacts(specimen);
    const auto parts = [&](std::size_t contact) {
        return fragments.of_grain[grains[contact][0]] != fragments.of_grain[grains[contact][1]];
    };
    map.draw_boundaries(parts, line);
    std::vector<LegendEntry> legend{{palette::grain, "largest fragment"}};
    if (count.fragments > 1) {
        legend.push_back({fragment_colour(1), "others, coloured"});
        legend.push_back({Stroke{palette::ink, line}, "between fragments"});
    }
    map.draw_legend(legend);
    return std::move(map).drawing();
}

Command fragments_plot() {
    return make_plot<MapPlotOptions>("fragments", "grains that are still connected, by fragment",
                                     {"brazilian.h5 -o fragments.png", "uniaxial.h5 --frame peak -o fragments.svg"}, one_run,
                                     add_map_options, [](const MapPlotOptions& options, const Call& call) {
                                         return draw_fragments(RunReader(call.file()), options.map, options.style);
                                     });
}

}  // namespace graincrack
