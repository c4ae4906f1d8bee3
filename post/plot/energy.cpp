#include "post/plot/energy.hpp"

#include <fmt/format.h>

#include "post/chart/chart.hpp"
#include "post/chart/numbers.hpp"
#include "post/measure/test_label.hpp"
#include "post/plot/make_plot.hpp"

namespace graincrack {

namespace {

struct Term {
    HistoryColumn column;
    const char* label;
    Stroke stroke;
};

const std::vector<Term>& terms() {
    using enum HistoryColumn;
    static const std::vector<Term> all{{energy_external, "external work", {palette::ink, 5}},
                                       {energy_strain, "strain", {palette::series(0), 4}},
                                       {energy_contact, "contacts", {palette::series(4), 4, Dash::long_dashed}},
                                       {energy_fracture_tension, "fracture, tension", {palette::tensile, 4, Dash::dash_dot}},
                                       {energy_fracture_shear, "fracture, shear", {palette::tensile, 4.5, Dash::dotted}},
                                       {energy_friction, "friction", {palette::series(2), 4, Dash::dashed}},
                                       {energy_damping, "damping", {palette::series(3), 6, Dash::dotted}},
                                       {energy_platen, "platens", {palette::series(5), 3, Dash::dashed}},
                                       {energy_kinetic, "kinetic", {palette::series(6), 2.5, Dash::dash_dot}},
                                       {non_conservative_work, "non-conservative work", {palette::rim, 2}}};
    return all;
}

}  // namespace

Drawing draw_energy(const RunData& run, const PictureStyle& style) {
    const double sense = run.header.test == "tension" ? 100 : -100;
    const std::vector<double> strain = times(run.history[HistoryColumn::axial_strain], sense);
    const bool loaded = largest(strain) > 0;
    const std::vector<double>& x = loaded ? strain : run.history[HistoryColumn::time];
    std::vector<double> all;
    for (const Term& term : terms()) all.insert(all.end(), run.history[term.column].begin(), run.history[term.column].end());
    Chart chart(
        style,
        {test_title(run.header),
         {fmt::format("energy balance per metre of thickness; largest residual {:.2g} % of the peak stored energy; damping "
                      "took {:.2g} % of the work",
                      100 * run.header.energy_balance_error, 100 * run.header.damping_share)}},
        Axis{loaded ? "axial strain, %" : "time, s", std::min(0.0, smallest(x)), 1.03 * largest(x)},
        Axis{"energy, J/m", padded_range(all, 0.04).first, padded_range(all, 0.04).second});
    for (const Term& term : terms()) {
        const std::vector<double>& values = run.history[term.column];
        if (largest(values) == 0 && smallest(values) == 0) continue;
        chart.line(x, values, term.stroke);
        chart.legend(term.stroke, term.label);
    }
    return chart.finish();
}

Command energy_plot() {
    return make_plot<PlotOptions>(
        "energy", "the energy balance over the strain", {"uniaxial.h5 -o energy.png", "brazilian.h5 -o energy.svg"}, one_run,
        add_chart,
        [](const PlotOptions& options, const Call& call) { return draw_energy(read_run_data(call.file()), options.style); });
}

}  // namespace graincrack
