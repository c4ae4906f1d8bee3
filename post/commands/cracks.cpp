#include "post/commands/cracks.hpp"

#include "post/option_parts.hpp"

namespace graincrack {

Command cracks_command() {
    struct Options {
        std::string folder;
        CrackExportOptions crack_export;
    };
    return make_command<Options>(
        "cracks", "grains and cracks as VTK series, crack log and rosette",
        {"uniaxial.h5 -o cracks", "brazilian.h5 --event-distance 10mm -o cracks"}, one_run,
        [](CLI::App& app, Options& options) {
            add_output(app, options.folder, "folder for grains.pvd, cracks.pvd and the tables");
            add_events(app, options.crack_export.events);
            add_crack_label(app, options.crack_export.label);
            add_format(app, options.crack_export.format);
        },
        [](const Options& options, const Call& call) {
            export_cracks(RunReader(call.file()), options.folder, options.crack_export, call.verbosity);
        });
}

}  // namespace graincrack
