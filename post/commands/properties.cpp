#include "post/commands/properties.hpp"

#include "post/fit/fit_options.hpp"
#include "post/options/common_options.hpp"
#include "post/report/properties.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

Command properties_command() {
    struct Options {
        std::string material;
        EnvelopeOptions envelope;
        TableFormat format = TableFormat::tsv;
    };
    return make_command<Options>(
        "properties", "elastic constants, strengths, cohesion and friction angle of a set of tests, compared with the laboratory",
        {"uniaxial.h5 triaxial.h5 brazilian.h5 --material augig-granite", "brazilian.h5 --material augig-granite --format jsonl"},
        several_runs,
        [](OptionSet set, Options& options) {
            add_laboratory_material(set, options.material).required();
            add_envelope_options(set, options.envelope);
            add_format(set, options.format);
        },
        [](const Options& options, const Call& call) {
            const Material material = read_incomplete_material_of(call, options.material).material;
            write_properties(call.out, measure_properties(read_runs(call.files), material, options.envelope), options.format);
        });
}

}  // namespace graincrack
