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
                                       {energy_contact, "contacts", {palette::series(4), 4}},
                                       {energy_fracture_tension, "fracture, tension", {palette::tensile, 4}},
                                       {energy_fracture_shear, "fracture, shear", {palette::tensile, 3, true}},
                                       {energy_friction, "friction", {palette::series(2), 4}},
                                       {energy_damping, "damping", {palette::series(3), 4}},
                                       {energy_platen, "platens", {palette::series(5), 3, true}},
                                       {energy_kinetic, "kinetic", {palette::series(6), 3, true}},
                                       {non_conservative_work, "non-conservative work", {palette::rim, 2.5, true}}};
    return all;
}

}  // namespace

Drawing draw_energy(const RunData& run) {
    const double sense = run.header.test == "tension" ? 100 : -100;
    const std::vector<double> strain = times(run.history[HistoryColumn::axial_strain], sense);
    const bool loaded = largest(strain) > 0;
    const std::vector<double>& x = loaded ? strain : run.history[HistoryColumn::time];
    std::vector<double> all;
    for (const Term& term : terms()) all.insert(all.end(), run.history[term.column].begin(), run.history[term.column].end());
    Chart chart({test_title(run.header),
                 {fmt::format("energy balance, J per metre of thickness; largest residual {:.2g} %",
                              100 * run.header.energy_balance_error),
                  fmt::format("of the peak stored energy; damping took {:.2g} % of the work", 100 * run.header.damping_share)}},
                Axis{loaded ? "axial strain, %" : "time, s", std::min(0.0, smallest(x)), 1.03 * largest(x)},
                Axis{"energy, J", padded_range(all, 0.04).first, padded_range(all, 0.04).second});
    for (const Term& term : terms()) {
        const std::vector<double>& values = run.history[term.column];
        if (largest(values) == 0 && smallest(values) == 0) continue;
        chart.line(x, values, term.stroke);
        chart.legend(term.stroke, term.label);
    }
    return chart.finish();
}

Command energy_plot() {
    return make_plot("energy", "the energy balance over the strain", {"uniaxial.h5 -o energy.png", "brazilian.h5 -o energy.svg"},
                     one_run, [](const Call& call) { return draw_energy(read_run_data(call.file())); });
}

}  // namespace graincrack
