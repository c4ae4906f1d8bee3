#include "mesher/import/import_specimen.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <numeric>
#include <utility>

#include "mesher/import/gmsh.hpp"
#include "mesher/import/label_image.hpp"
#include "mesher/import/label_table.hpp"
#include "share/base/error.hpp"
#include "share/base/sha256.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"
#include "share/file/output_file.hpp"
#include "share/file/specimen_measures.hpp"

namespace graincrack::mesher {

namespace {

constexpr const char* known_formats =
    "a mesh of Gmsh or Neper (.msh) or a picture of labels (PNG, or integers as text) is needed";

std::optional<MeshFormat> format_of(std::string_view bytes) {
    if (is_gmsh(bytes)) return MeshFormat::gmsh;
    if (looks_like_labels(bytes)) return MeshFormat::labels;
    return std::nullopt;
}

std::string beginning(std::string_view bytes) {
    const std::string_view line = bytes.substr(0, std::min<std::size_t>(bytes.find_first_of("\r\n"), 40));
    return printable(std::string(line));
}

std::string name_of_file(const ImportRequest& request) { return request.file == "-" ? "stdin" : request.file; }

MeshFormat known_format(std::string_view bytes, const ImportRequest& request) {
    const std::string name = name_of_file(request);
    if (bytes.starts_with("\xff\xd8\xff")) {
        throw InputError(name +
                         ": is a JPEG, in which colours run into each other; save it as PNG of labels, one colour for each " +
                         "grain or mineral (in GIMP: Image > Mode > Indexed, then Export As)");
    }
    const auto format = request.format ? request.format : format_of(bytes);
    if (format) return *format;
    if (is_binary(bytes)) throw InputError(fmt::format("{}: is no whole PNG and no text; {}", name, known_formats));
    const bool is_abaqus = trimmed(bytes).starts_with('*');
    throw InputError(fmt::format(
        "{}: begins with \"{}\"; {}", name, beginning(trimmed(bytes)),
        is_abaqus ? "a file of Abaqus is converted by: meshio convert --ascii --output-format gmsh22 mesh.inp mesh.msh"
                  : known_formats));
}

LabelOptions label_options(const ImportRequest& request, const PhaseKey& key) {
    LabelOptions options = request.labels;
    if (key.is_given()) options.phases = key.of_labels();
    return options;
}

PhaseKey key_of(const ImportRequest& request) { return request.phase_key.empty() ? PhaseKey{} : PhaseKey(request.phase_key); }

std::string read_bytes(const std::string& file) {
    if (file == "-") {
        std::string bytes = text_of_stream(std::cin, "stdin");
        if (bytes.empty()) throw InputError("stdin: empty: the program before wrote nothing; see its message");
        return bytes;
    }
    if (std::filesystem::is_directory(file)) throw InputError(fmt::format("{}: is a folder; {}", file, known_formats));
    std::string bytes = text_of_file(file);
    if (bytes.empty()) throw InputError(fmt::format("{}: is empty; {}", file, known_formats));
    return bytes;
}

/// The labels of a picture, with the phases of the key.
std::vector<LabelRow> picture_labels(std::string_view bytes, const ImportRequest& request) {
    const std::string name = name_of_file(request);
    if (known_format(bytes, request) != MeshFormat::labels) {
        throw UsageError("--write-key: " + name + " is no picture; the key of a mesh has the names or numbers of its groups");
    }
    return labels_of(bytes, label_options(request, key_of(request)), name);
}

}  // namespace

ImportedMesh import_mesh(std::string_view bytes, const ImportRequest& request) {
    const std::string name = name_of_file(request);
    if (request.crystals == CrystalChoice::breaking && request.grains == GrainChoice::element) {
        throw UsageError(
            "--crystals break: with --grain element each element is a crystal, so that none can break; leave one out");
    }
    const PhaseKey key = key_of(request);
    const MeshFormat format = known_format(bytes, request);
    if (format == MeshFormat::labels && !(request.labels.pixel_size > 0)) {
        throw UsageError("--pixel-size: missing; a picture needs the length of a pixel's side, as 0.1mm");
    }
    if (format != MeshFormat::labels && request.labels.pixel_size > 0) {
        throw UsageError("--pixel-size: " + name + " is no picture; give --scale for the unit of a mesh");
    }
    if (format == MeshFormat::labels) {
        if (request.grains == GrainChoice::physical) throw UsageError("--grain physical: " + name + " has no physical groups");
        ImportedMesh mesh = import_labels(bytes, label_options(request, key), name);
        mesh.phases = key.phases();
        if (request.grains == GrainChoice::element) make_grains_of_triangles(mesh);
        return mesh;
    }
    return imported_mesh(read_gmsh(bytes, name), request.grains, key, name);
}

namespace {

constexpr double preferred = 0.15;  ///< psi6 above which a mesh has a preferred direction, as for meshes made here

std::string mm(double length) { return fmt::format("{:.4g} mm", in_unit(length, Dimension::length, "mm")); }

/// Line with the parts of the boundary and their lengths.
std::string parts_line(const Specimen& specimen) {
    std::vector<double> lengths(specimen.part_names.size(), 0);
    for (std::size_t b = 0; b < specimen.n_boundary_edges(); ++b) {
        const auto& [i, j] = specimen.boundary_edges[b];
        const auto& p = specimen.node_position[index(i)];
        const auto& q = specimen.node_position[static_cast<std::size_t>(j)];
        lengths[specimen.boundary_part[b]] += std::hypot(q[0] - p[0], q[1] - p[1]);
    }
    std::string line = "parts of the boundary:";
    for (std::size_t part = 0; part < lengths.size(); ++part) {
        if (lengths[part] == 0) continue;
        line += fmt::format("{} {} {}", line.ends_with(':') ? "" : ",", specimen.part_names[part], mm(lengths[part]));
    }
    return line;
}

}  // namespace

Import import_specimen(const ImportRequest& request, Fabric fabric, std::uint64_t seed) {
    const std::string bytes = read_bytes(request.file);
    Import import;
    import.digest = sha256_of(bytes);
    ImportedMesh mesh = import_mesh(bytes, request);
    import.format = mesh.format;
    import.labels = std::move(mesh.labels);
    import.specimen = assemble(std::move(mesh), request.placement, request.crystals, request.file == "-" ? "stdin" : request.file,
                               import.notes);
    if (import.has_phases()) {
        if (!fabric.phases.fractions.empty() && !fabric.phases.yield) {
            throw UsageError("--phases: the file says of what phases its grains are; leave the option out, or give --phase-key");
        }
        fabric.phases.fractions.clear();
    }
    std::vector<int> crystals = import.specimen.grain_crystal;
    const bool can_break = !crystals.empty();
    if (!can_break) {
        crystals.resize(import.specimen.n_grains());
        std::iota(crystals.begin(), crystals.end(), 0);
    }
    give_fabric(import.specimen, crystals, fabric, seed, 0, can_break);
    return import;
}

std::vector<std::string> write_new_key(const ImportRequest& request) {
    // Phases entered by hand must not be lost.
    if (request.new_key != request.phase_key && std::filesystem::is_regular_file(request.new_key)) {
        throw UsageError(
            fmt::format("--write-key: {0} is there already; give another name, or --phase-key {0} too, whose phases the "
                        "new key then has",
                        request.new_key));
    }
    const std::vector<LabelRow> rows = picture_labels(read_bytes(request.file), request);
    write_whole_file(request.new_key, key_of_labels(rows, request.file == "-" ? "stdin" : request.file));
    return describe_labels(rows);
}

std::vector<Remark> describe(const Import& import) {
    const Specimen& specimen = import.specimen;
    const MeshStatistics& s = specimen.statistics;
    std::vector<Remark> lines{
        fmt::format("from {}: {} nodes, {} boundary edges", import.format, specimen.n_nodes(), specimen.n_boundary_edges()),
        fmt::format("edge mean {}, CV {:.4f}, min {}, max {}; smallest angle {:.1f} deg, psi6 {:.3f}", mm(s.mean_edge),
                    s.edge_variation, mm(s.min_edge), mm(s.max_edge), s.min_angle * 180 / std::numbers::pi, s.psi6),
        parts_line(specimen),
    };
    if (const std::string open = open_boundaries_text(specimen); !open.empty()) lines.push_back("open boundaries: " + open);
    if (!import.labels.empty()) {
        for (const std::string& line : describe_labels(import.labels)) lines.push_back(line);
    }
    if (specimen.n_elements() == specimen.n_grains() && s.psi6 > preferred) {
        lines.emplace_back(
            "edges have preferred directions (psi6), which steer cracks; Gmsh's Mesh.Algorithm = 5 makes meshes "
            "without",
            "preferred_directions");
    }
    if (const std::string note = note_on_few_crystals(specimen); !note.empty()) lines.emplace_back(note, "few_crystals");
    lines.insert(lines.end(), import.notes.begin(), import.notes.end());
    return lines;
}

}  // namespace graincrack::mesher
