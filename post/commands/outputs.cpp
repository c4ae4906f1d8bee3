// Commands that write pages, pictures and folders of a run.
#include "post/commands/commands.hpp"

#include "post/cracks/export.hpp"
#include "post/export/mesh_file.hpp"
#include "post/options/command.hpp"
#include "post/plot/plot_commands.hpp"
#include "post/report/report.hpp"
#include "post/report/view_page.hpp"
#include "share/base/events.hpp"
#include "share/base/text.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/output_file.hpp"
#include "share/options/option_set.hpp"

#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace graincrack {

Command cracks_command() {
    struct Options {
        std::string folder;
        CrackExportOptions crack_export;
    };
    return make_command<Options>(
        "cracks", "grains and cracks as VTK series; tables of cracks, events, fragments and directions",
        {"uniaxial.h5 -o cracks", "brazilian.h5 --event-distance 10mm -o cracks"}, one_run,
        [](OptionSet set, Options& options) {
            add_output(set, options.folder, "folder for grains.pvd, cracks.pvd and the tables", {});
            constexpr Quantity distance{"event_distance", Dimension::length, 0, 1e3, "distance within an acoustic event"};
            constexpr Quantity time{"event_time", Dimension::time, 0, 1e6, "time within an acoustic event"};
            EventOptions& events = options.crack_export.events;
            add_quantity(set, "--event-distance", events.distance, distance,
                         "crack points within this distance belong to one acoustic event; default: two mean edges");
            add_quantity(set, "--event-time", events.time, time,
                         "crack points within this time belong to one acoustic event; default: that distance at half the speed "
                         "of shear waves");
            add_crack_label(set, options.crack_export.label);
            add_format(set, options.crack_export.format);
        },
        [](const Options& options, const Call& call) {
            export_cracks(RunReader(call.file()), options.folder, options.crack_export, call.verbosity);
        });
}

Command report_command() {
    struct Options {
        ReportOptions report;
        std::string material;
        std::string page;
    };
    return make_command<Options>(
        "report", "report of one test or of a set of tests as a self-contained HTML page",
        {"uniaxial.h5 -o page.html", "uniaxial.h5 triaxial.h5 brazilian.h5 --material augig-granite -o page.html"}, several_runs,
        [](OptionSet set, Options& options) {
            add_text(set, "--material", options.material,
                     "material with the laboratory values and targets to compare with; default: that of the first run, if it "
                     "is found where the run names it");
            add_crack_label(set, options.report.label);
            add_output(set, options.page, "page: .html", {".html"});
        },
        [](const Options& options, const Call& call) {
            require_ending(options.page, ".html");
            ReportOptions report = options.report;
            if (!options.material.empty()) report.material = read_material(options.material);
            write_whole_file(options.page, make_report(call.files, report, call.verbosity, call.diagnostics()));
        });
}

Command view_command() {
    struct Options {
        ViewOptions view;
        std::string page;
    };
    return make_command<Options>(
        "view", "a page in which tests are turned over in the browser: states, cracks, stresses, load curve",
        {"uniaxial.h5 -o view.html", "uniaxial.h5 triaxial.h5 --frames 40 -o view.html"}, several_runs,
        [](OptionSet set, Options& options) {
            add_integer(
                set, "--frames", options.view.frames,
                "most frames of a run in the page, evenly chosen; the first, that of the peak and the last are among them", 3,
                1000);
            add_crack_label(set, options.view.label);
            add_output(set, options.page, "page: .html", {".html"});
        },
        [](const Options& options, const Call& call) {
            require_ending(options.page, ".html");
            write_whole_file(options.page, make_view(call.files, options.view, call.verbosity));
        });
}

Command plot_command() { return make_group("plot", "pictures as PNG, SVG or PDF; no display needed", plot_commands()); }

Command export_command() {
    return make_command<std::string>(
        "export", "the mesh of a specimen for other programs, in the format of Gmsh", {"disc.h5 -o disc.msh", "uniaxial.h5 -o -"},
        FileArguments{"file", "specimen or run"},
        [](OptionSet set, std::string& mesh) {
            add_output(set, mesh, "mesh in the format MSH 2.2 of Gmsh: .msh; - is stdout", {".msh"});
        },
        [](const std::string& output, const Call& call) {
            if (!is_stream(output)) require_ending(output, ".msh");
            const SharedMesh mesh = share_nodes(read_specimen(H5Input(call.file())));
            write_whole_file(output, gmsh_text(mesh));
            const std::vector<std::string> lost = losses(mesh);
            if (lost.empty()) return;
            say(call.diagnostics(), fmt::format("graincrack-post: export: {} {}", output == "-" ? "stdout" : printable(output),
                                                fmt::join(lost, ", ")));
        });
}

}  // namespace graincrack
