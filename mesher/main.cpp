// graincrack-mesh makes specimens of grains from shapes.
//
//     graincrack-mesh rectangle --width 80mm --height 160mm --grains 1122 -o specimen.h5
//     graincrack-mesh disc --diameter 80mm --edge 5.13mm --seed 7 --material augig-granite -o disc.h5
//     graincrack-mesh import section.msh --scale 1mm -o section.h5
//     graincrack-mesh rectangle --width 40mm --height 80mm --edge 3mm --phases quartz=0.3,feldspar=0.6,mica=0.1 -o minerals.h5
#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "mesher/import/import_specimen.hpp"
#include "mesher/mesh.hpp"
#include "mesher/mesh_options.hpp"
#include "mesher/mesh_report.hpp"
#include "mesher/plane/triangulation.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/progress.hpp"
#include "share/base/units.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/provenance.hpp"
#include "share/rock/material.hpp"

namespace {

using namespace graincrack;
using namespace graincrack::mesher;

template <class Line>
void print(std::ostream& stream, const std::vector<Line>& lines) {
    for (const auto& line : lines) {
        const Remark remark(line);
        stream << (remark.code.empty() ? "" : "warning: ") << remark.text << '\n';
    }
}

/// Writes the specimen with its provenance.
void write(H5Output& file, const Specimen& specimen, const std::string& input_digest, const MeshOptions& options, int argc,
           char** argv, std::chrono::steady_clock::time_point start) {
    write_specimen(file, specimen);
    Provenance provenance;
    provenance.tool = "graincrack-mesh";
    provenance.command_line.assign(argv, argv + argc);
    provenance.configuration = options.configuration;
    provenance.material = options.material_name;
    provenance.input_digest = input_digest;
    provenance.libraries = library_versions();
    provenance.libraries.push_back(triangulation_library());
    provenance.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    write_provenance(file, provenance);
    file.commit();
}

/// Prints the summary of a specimen and its warnings, and with --verbose the other lines.
void tell(const MeshOptions& options, const Specimen& specimen, std::vector<Remark> lines) {
    std::ostream& out = diagnostics(options.verbosity);
    for (const std::string& line : summary_of(specimen, options.output)) say(out, line);
    if (options.material) {
        write_notes(out, "graincrack-mesh", *options.material);
        const std::vector<Remark> zones = describe_zones(*options.material, specimen);
        lines.insert(lines.end(), zones.begin(), zones.end());
    }
    for (const Remark& line : lines) {
        if (!line.code.empty()) {
            warn(out, "graincrack-mesh", line, options.output);
        } else if (options.verbosity == Verbosity::verbose) {
            say(out, "  " + line.text);
        }
    }
}

int run(int argc, char** argv) {
    const auto start = std::chrono::steady_clock::now();
    catch_stop_signals(1);

    // Options
    auto options = read_options(argc, argv);
    if (!options) return 0;
    const Request& request = options->request;

    // Imported mesh
    if (options->imported && !options->imported->new_key.empty()) {
        const std::vector<std::string> labels = write_new_key(*options->imported);
        if (options->dry_run || options->verbosity != Verbosity::quiet) print(options->dry_run ? std::cout : std::cerr, labels);
        return 0;
    }
    if (options->imported) {
        Import mesh = import_specimen(*options->imported, request.fabric, request.seed);
        mesh.specimen.settings = options->settings;
        if (options->dry_run) {
            print(std::cout, summary_of(mesh.specimen, ""));
            print(std::cout, describe(mesh));
            return 0;
        }
        H5Output file(options->output, "specimen");
        write(file, mesh.specimen, mesh.digest, *options, argc, argv, start);
        tell(*options, mesh.specimen, describe(mesh));
        return 0;
    }

    if (options->dry_run) {
        print(std::cout, describe_plan(request));
        return 0;
    }
    plan_mesh(request);  // errors in the request are reported before a file is opened

    // Mesh
    H5Output file(options->output, "specimen");
    Progress progress("mesh", options->verbosity);
    MeshReport report;
    Specimen specimen = mesh(
        request, [&](double fraction) { progress.update(fraction, ""); }, &report);
    specimen.settings = options->settings;
    progress.finish();
    write(file, specimen, "", *options, argc, argv, start);

    // Report
    std::vector<Remark> lines = describe_mesh(specimen, request, report);
    if (length(options->moved) > 0) {
        lines.push_back(fmt::format("moved by ({}, {}), so that the middle of its extent is the origin",
                                    format_length(options->moved.x), format_length(options->moved.y)));
    }
    tell(*options, specimen, std::move(lines));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return graincrack::run_tool("graincrack-mesh", [&] { return run(argc, argv); });
}
