#include "post/plot/abscissa.hpp"

#include <algorithm>

#include "post/chart/numbers.hpp"

namespace graincrack {

void add_abscissa(OptionSet set, Abscissa& abscissa) {
    add_choice<Abscissa>(set, "--x", abscissa, {{"time", Abscissa::time}, {"strain", Abscissa::strain}},
                         "level axis: time, which spreads what happens at the peak, or axial strain");
}

Course course_of(const RunData& run, Abscissa abscissa) {
    const double sense = run.header.test == "tension" ? 100 : -100;
    const std::vector<double> strain = times(run.history[HistoryColumn::axial_strain], sense);
    const bool by_strain = abscissa == Abscissa::strain && largest(strain) > 0;
    std::vector<double> values = by_strain ? strain : times(run.history[HistoryColumn::time], 1e3);
    const Axis axis{by_strain ? "axial strain, %" : "time, ms", std::min(0.0, smallest(values)), 1.03 * largest(values)};
    return {axis, std::move(values)};
}

}  // namespace graincrack
