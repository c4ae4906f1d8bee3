#include "post/commands/cracks.hpp"

#include "post/cracks/class_counts.hpp"
#include "post/cracks/crack_options.hpp"
#include "post/options/common_options.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

Command cracks_command() {
    struct Options {
        std::string folder;
        CrackExportOptions crack_export;
    };
    return make_command<Options>(
        "cracks", "grains and cracks as VTK series; tables of cracks, events, fragments and directions",
        {"uniaxial.h5 -o cracks", "brazilian.h5 --event-distance 10mm -o cracks --paraview"}, one_run,
        [](OptionSet set, Options& options) {
            add_output(set, options.folder, "folder for grains.pvd, cracks.pvd and the tables");
            add_events(set, options.crack_export.events);
            add_crack_label(set, options.crack_export.label);
            add_format(set, options.crack_export.format);
            add_flag(set, "--paraview", options.crack_export.paraview,
                     "also write open_in_paraview.py, which shows grains and cracks with colours and times: paraview "
                     "--script=FILE, or pvbatch FILE PICTURE.png");
        },
        [](const Options& options, const Call& call) {
            export_cracks(RunReader(call.file()), options.folder, options.crack_export, call.verbosity);
        });
}

Command classes_command() {
    struct Options {
        std::optional<TableFormat> format;
        CrackLabelChoice label;
    };
    return make_command<Options>(
        "classes", "contacts and micro-cracks for each class (pair of minerals), one row per class",
        {"uniaxial.h5", "uniaxial.h5 brazilian.h5 --crack-event broken --format jsonl"}, several_runs,
        [](OptionSet set, Options& options) {
            add_crack_label(set, options.label);
            add_format(set, options.format);
        },
        [](const Options& options, const Call& call) {
            std::vector<RunClasses> runs;
            for (const std::string& file : call.files) runs.push_back(read_classes(RunReader(file), options.label));
            write_class_counts(call.out, runs, format_for(options.format, call.out));
        });
}

}  // namespace graincrack
