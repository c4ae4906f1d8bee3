#include "post/fit/fit_options.hpp"

#include "post/options/command.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

void add_strain_limit_runs(OptionSet set, StrainLimitRuns& strain_limit_runs) {
    add_choice<StrainLimitRuns>(
        set, "--capped", strain_limit_runs, {{"refuse", StrainLimitRuns::refuse}, {"accept", StrainLimitRuns::accept}},
        "runs stopped at the strain limit: refuse them, or accept their largest stress as a strength and say so");
}

void add_envelope_options(OptionSet set, EnvelopeOptions& options) {
    add_strain_limit_runs(set, options.strain_limit_runs);
    add_choice<StrengthKind>(
        set, "--strength", options.strength,
        {{name_of(StrengthKind::first_peak), StrengthKind::first_peak},
         {name_of(StrengthKind::largest), StrengthKind::largest},
         {name_of(StrengthKind::residual), StrengthKind::residual}},
        "which stress of a compression test is taken as its strength: the first peak, as laboratories report it, "
        "the largest or the residual one; runs without it are left out");
}

}  // namespace graincrack
