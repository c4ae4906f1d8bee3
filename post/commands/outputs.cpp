// Commands that write pages, pictures and folders of a run.
#include "post/commands/commands.hpp"

#include "post/cracks/export.hpp"
#include "post/export/mesh_file.hpp"
#include "post/fit/envelope.hpp"
#include "post/options/command.hpp"
#include "post/plot/plot_commands.hpp"
#include "post/report/report.hpp"
#include "post/report/view_page.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/text.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/output_file.hpp"
#include "share/options/option_set.hpp"

#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <optional>
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
            add_events(set, options.crack_export.events);
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
        std::string view;
    };
    return make_command<Options>(
        "report", "report of one test or of a set of tests as a self-contained HTML page",
        {"uniaxial.h5 -o page.html", "uniaxial.h5 triaxial.h5 brazilian.h5 --material augig-granite -o page.html"}, several_runs,
        [](OptionSet set, Options& options) {
            add_text(set, "--material", options.material,
                     "material with the laboratory values and targets to compare with; default: that of the first run, if it "
                     "is found where the run names it");
            add_crack_label(set, options.report.label);
            add_text(set, "--view", options.view, "write the page of view too, and link to it: .html").type_name("FILE");
            add_output(set, options.page, "page: .html", {".html"});
        },
        [](const Options& options, const Call& call) {
            require_ending(options.page, ".html");
            ReportOptions report = options.report;
            if (!options.material.empty()) report.material = read_material(options.material);
            if (!options.view.empty()) {
                require_ending(options.view, ".html");
                if (options.view == options.page) {
                    throw UsageError("--view " + options.view + ": is the report; another name is needed");
                }
                write_whole_file(options.view, make_view(call.files, {report.label}, call.verbosity));
                report.view =
                    std::filesystem::proximate(options.view, std::filesystem::absolute(options.page).parent_path()).string();
            }
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
    struct Options {
        std::string mesh;
        std::optional<MeshFormat> format;
    };
    return make_command<Options>(
        "export", "the mesh of a specimen for other programs: Gmsh, VTK", {"disc.h5 -o disc.msh", "uniaxial.h5 -o uniaxial.vtu"},
        FileArguments{"file", "specimen or run"},
        [](OptionSet set, Options& options) {
            add_output(set, options.mesh, "mesh: .msh (Gmsh) or .vtu (VTK); - is stdout", {".msh", ".vtu"});
            add_choice<std::optional<MeshFormat>>(set, "--format", options.format,
                                                  {{"gmsh", MeshFormat::gmsh}, {"vtu", MeshFormat::vtu}},
                                                  "MSH 2.2 of Gmsh or an XML file of VTK; default: by the ending of --output");
        },
        [](const Options& options, const Call& call) {
            const MeshFormat format = mesh_format_of(options.mesh, options.format);
            const SharedMesh mesh = share_nodes(read_specimen(H5Input(call.file())));
            write_whole_file(options.mesh, format == MeshFormat::gmsh ? gmsh_text(mesh) : vtu_text(mesh));
            const std::vector<std::string> lost = losses(mesh, format);
            if (lost.empty()) return;
            say(call.diagnostics(), fmt::format("graincrack-post: export: {} {}",
                                                options.mesh == "-" ? "stdout" : printable(options.mesh), fmt::join(lost, ", ")));
        });
}

}  // namespace graincrack
