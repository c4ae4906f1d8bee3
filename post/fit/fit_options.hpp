// Options of commands that fit lines and envelopes to strengths and tables.
#pragma once

#include "post/fit/envelope.hpp"
#include "post/fit/trend.hpp"
#include "post/measure/strength.hpp"
#include "post/options/command.hpp"

namespace graincrack {

/// --capped and --strength: which runs an envelope has, and which stress of them.
void add_envelope_options(OptionSet set, EnvelopeOptions& options);
/// --capped refuse|accept
void add_strain_limit_runs(OptionSet set, StrainLimitRuns& strain_limit_runs);
inline constexpr FileArguments trend_tables{"tables",
                                            "tables: tab-separated values with one header line; their rows are combined"};
/// --x, --y, --power, --group: a line or power law through columns of tables.
void add_trend(OptionSet set, TrendOptions& options);

}  // namespace graincrack
