#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "post/chart/axis.hpp"
#include "post/chart/chart.hpp"
#include "post/run/test_label.hpp"

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

/// Terms below this fraction of the largest are not visible in a picture.
constexpr double least_share = 1e-3;

double magnitude(const std::vector<double>& values) { return std::max(largest(values), -smallest(values)); }

}  // namespace

Drawing draw_energy(const RunData& run, const PictureStyle& style) {
    const std::vector<double> time = times(run.history[HistoryColumn::time], 1e3);
    std::vector<double> all;
    for (const Term& term : terms()) all.insert(all.end(), run.history[term.column].begin(), run.history[term.column].end());
    const auto [low, high] = padded_range(all, 0.04);
    Chart chart(
        style,
        {test_title(run.header),
         {fmt::format("energy balance per metre of thickness; largest residual {:.2g} % of the peak stored energy; damping "
                      "took {:.2g} % of the work",
                      100 * run.header.energy_balance_error, 100 * run.header.damping_share)}},
        Axis{"time, ms", std::min(0.0, smallest(time)), 1.03 * largest(time)}, Axis{"energy, J/m", low, high});
    if (const auto curve = load_curve_if_any(run)) {
        const double peak = time[curve->peak];
        chart.line({peak, low}, {peak, high}, {palette::rim, 2, Dash::dashed}, curve->peak_name());
    }
    std::string left_out;
    for (const Term& term : terms()) {
        const std::vector<double>& values = run.history[term.column];
        if (magnitude(values) < least_share * magnitude(all)) {
            left_out += (left_out.empty() ? "" : ", ") + std::string(term.label);
            continue;
        }
        chart.line(time, values, term.stroke, term.label);
    }
    if (!left_out.empty()) chart.add_note("below 0.1 % of the largest, and not shown: " + left_out);
    return chart.finish();
}

}  // namespace graincrack
