// Options of commands that fit lines and envelopes to strengths and tables.
#pragma once

#include "post/fit/envelope.hpp"
#include "post/measure/strength.hpp"
#include "post/options/command.hpp"

namespace graincrack {

/// --capped and --strength: which runs an envelope has, and which stress of them.
void add_envelope_options(OptionSet set, EnvelopeOptions& options);
/// --capped refuse|accept
void add_strain_limit_runs(OptionSet set, StrainLimitRuns& strain_limit_runs);

}  // namespace graincrack
