#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/chart/chart.hpp"
#include "post/cracks/export.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"
#include "share/base/error.hpp"

namespace graincrack {

Drawing draw_emission(const std::vector<EmissionEvent>& events, const std::string& title, const std::string& run,
                      const PictureStyle& style) {
    std::vector<double> magnitudes = magnitudes_of(events);
    if (magnitudes.empty()) throw InputError(run + ": no events of acoustic emission; the run has no micro-cracks");
    std::sort(magnitudes.begin(), magnitudes.end());
    std::vector<double> number;
    for (std::size_t i = 0; i < magnitudes.size(); ++i) number.push_back(static_cast<double>(magnitudes.size() - i));
    const auto fit = fit_gutenberg_richter(magnitudes, completeness_of(magnitudes));
    std::vector<std::string> subtitle{counted(events.size(), "event")};
    const bool is_line = fit && fit->follows_line();
    subtitle[0] += !fit      ? ", too few for a slope"
                   : is_line ? fmt::format(", b = {:.2f} ± {:.2f} from magnitude {:.2f} ({} events)", fit->b, fit->error,
                                           fit->completeness, fit->events)
                             : fmt::format(
                                   ", no slope b: from magnitude {:.2f} on they do not lie on a line (farthest {:.2f}, at most "
                                   "{:.2f} by chance)",
                                   fit->completeness, fit->distance, fit->distance_by_chance());
    const auto [low, high] = padded_range(magnitudes, 0.08);
    Chart chart(style, {title, subtitle}, Axis{"magnitude, per metre of thickness", low, high},
                Axis{"events at or above", 0.8, 1.5 * number.front(), true});
    const Marker marker{palette::series(0), MarkerShape::disc, 9};
    chart.points(magnitudes, number, marker);
    chart.legend(marker, "events");
    if (is_line) {
        const double at = std::log10(static_cast<double>(fit->events));
        const double end = fit->completeness + at / fit->b;
        const Stroke stroke{palette::ink, 3.5};
        chart.line(std::vector<double>{fit->completeness, end}, std::vector<double>{static_cast<double>(fit->events), 1}, stroke);
        chart.legend(stroke, "slope b (Aki)");
    }
    return chart.finish();
}

Command emission_plot() {
    struct Options : PlotOptions {
        EventOptions events;
    };
    return make_plot<Options>(
        "emission", "acoustic emission: number of events by magnitude, b-value",
        {"uniaxial.h5 -o emission.png", "uniaxial.h5 --event-distance 4mm -o emission.svg"}, one_run,
        [](OptionSet set, Options& options) {
            add_chart(set, options);
            add_events(set, options.events);
        },
        [](const Options& options, const Call& call) {
            const RunReader run(call.file());
            const Specimen specimen = run.specimen();
            return draw_emission(emission_of(run, specimen, options.events), test_title(run.header()), run.name(), options.style);
        });
}

}  // namespace graincrack
