#include "post/commands/cracks.hpp"

#include "post/option_parts.hpp"
#include "share/command_line.hpp"

namespace graincrack {

Command cracks_command() {
    struct Options {
        std::string folder;
        CrackExportOptions crack_export;
    };
    return make_command<Options>(
        "cracks", "grains and cracks as VTK series, crack log and rosette",
        {"uniaxial.h5 -o cracks", "brazilian.h5 --event-distance 10mm -o cracks --paraview"}, one_run,
        [](CLI::App& app, Options& options) {
            add_output(app, options.folder, "folder for grains.pvd, cracks.pvd and the tables");
            add_events(app, options.crack_export.events);
            add_crack_label(app, options.crack_export.label);
            add_format(app, options.crack_export.format);
            app.add_flag("--paraview", options.crack_export.paraview,
                         "also write open_in_paraview.py, which opens grains, cracks, colours and time at once: paraview "
                         "--script=FILE, or pvbatch FILE PICTURE.png");
        },
        [](const Options& options, const Call& call) {
            export_cracks(RunReader(call.file()), options.folder, options.crack_export, call.verbosity);
        });
}

}  // namespace graincrack
