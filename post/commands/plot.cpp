#include "post/commands/plot.hpp"

#include "post/plot/counts.hpp"
#include "post/plot/cracks.hpp"
#include "post/plot/curve.hpp"
#include "post/plot/emission.hpp"
#include "post/plot/energy.hpp"
#include "post/plot/envelope.hpp"
#include "post/plot/fragments.hpp"
#include "post/plot/law.hpp"
#include "post/plot/rosette.hpp"
#include "post/plot/size_effect.hpp"
#include "post/plot/specimen.hpp"
#include "post/plot/strength.hpp"
#include "post/plot/surface.hpp"
#include "post/plot/table.hpp"
#include "post/plot/thresholds.hpp"
#include "post/plot/trend.hpp"

namespace graincrack {

/// The pictures in the order of --help.
Command plot_command() {
    return make_group("plot", "pictures as PNG, SVG or PDF; no display needed",
                      {
                          specimen_plot(),
                          curve_plot(),
                          strength_plot(),
                          cracks_plot(),
                          fragments_plot(),
                          rosette_plot(),
                          counts_plot(),
                          emission_plot(),
                          energy_plot(),
                          thresholds_plot(),
                          envelope_plot(),
                          size_effect_plot(),
                          surface_plot(),
                          law_plot(),
                          lennard_jones_plot(),
                          trend_plot(),
                          table_plot(),
                      });
}

}  // namespace graincrack
