#include "post/commands/size_effect.hpp"

#include "post/fit/fit_options.hpp"
#include "post/fit/size_effect.hpp"
#include "post/options/common_options.hpp"

namespace graincrack {

Command size_effect_command() {
    struct Options {
        TableFormat format = TableFormat::tsv;
        StrainLimitRuns strain_limit_runs = StrainLimitRuns::refuse;
    };
    return make_command<Options>(
        "size-effect", "power law of strength against mean edge, one fit for each test and confining pressure",
        {"brazilian-coarse.h5 brazilian.h5", "brazilian-coarse.h5 brazilian.h5 --capped accept --format jsonl"}, several_runs,
        [](OptionSet set, Options& options) {
            add_format(set, options.format);
            add_strain_limit_runs(set, options.strain_limit_runs);
        },
        [](const Options& options, const Call& call) {
            write_size_effect_table(call.out, read_runs(call.files), options.format, options.strain_limit_runs,
                                    call.diagnostics());
        });
}

}  // namespace graincrack
