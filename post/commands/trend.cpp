#include "post/commands/trend.hpp"

#include "post/fit/fit_options.hpp"
#include "post/options/common_options.hpp"

namespace graincrack {

Command trend_command() {
    struct Options {
        TrendOptions trend;
        TableFormat format = TableFormat::tsv;
    };
    return make_command<Options>(
        "trend", "straight line or power law between two columns, with intervals and elasticity",
        {"strength.tsv --x mean_edge_mm --y tensile_strength_MPa --power",
         "strength.tsv --x contact_cohesion_MPa --y peak_compressive_stress_MPa --group confining_pressure_MPa"},
        trend_tables,
        [](OptionSet set, Options& options) {
            add_trend(set, options.trend);
            add_format(set, options.format);
        },
        [](const Options& options, const Call& call) {
            write_trend_table(call.out, call.files, options.trend, options.format, call.diagnostics());
        });
}

}  // namespace graincrack
