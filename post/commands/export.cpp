#include "post/commands/commands.hpp"

#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <optional>
#include <string>
#include <vector>

#include "post/export/mesh_file.hpp"
#include "post/export/shared_mesh.hpp"
#include "post/options/command.hpp"
#include "share/base/printable.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/output_file.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

struct ExportOptions {
    std::string mesh;
    std::optional<MeshFormat> format;
};

void add_export_options(OptionSet set, ExportOptions& options) {
    add_output(set, options.mesh, "mesh: .msh (Gmsh), .vtu (VTK) or .inp (Abaqus); - is stdout");
    add_choice<std::optional<MeshFormat>>(
        set, "--format", options.format, {{"gmsh", MeshFormat::gmsh}, {"vtu", MeshFormat::vtu}, {"abaqus", MeshFormat::abaqus}},
        "MSH 2.2 of Gmsh, an XML file of VTK, or an input file of Abaqus; default: by the ending of --output");
}

std::string text_of(const SharedMesh& mesh, MeshFormat format, const std::string& specimen) {
    switch (format) {
        case MeshFormat::gmsh: return gmsh_text(mesh);
        case MeshFormat::vtu: return vtu_text(mesh);
        case MeshFormat::abaqus: return abaqus_text(mesh, specimen);
    }
    return "";
}

void export_mesh(const ExportOptions& options, const Call& call) {
    if (options.format) require_mesh_format(options.mesh, *options.format);
    const MeshFormat format = options.format ? *options.format : mesh_format_of(options.mesh);
    const H5Input file(call.file());
    const SharedMesh mesh = share_nodes(read_specimen(file));
    write_whole_file(options.mesh, text_of(mesh, format, file.name()));
    const std::vector<std::string> lost = losses(mesh, format);
    if (lost.empty()) return;
    fmt::print(call.diagnostics(), "graincrack-post: export: {} {}\n", options.mesh == "-" ? "stdout" : printable(options.mesh),
               fmt::join(lost, ", "));
}

}  // namespace

Command export_command() {
    return make_command<ExportOptions>("export", "the mesh of a specimen for other programs: Gmsh, VTK, Abaqus",
                                       {"disc.h5 -o disc.msh", "uniaxial.h5 -o uniaxial.inp"},
                                       FileArguments{"file", "specimen or run"}, add_export_options, export_mesh);
}

}  // namespace graincrack
