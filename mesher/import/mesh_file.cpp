#include "mesher/import/mesh_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <utility>

#include "mesher/import/abaqus.hpp"
#include "mesher/import/gmsh.hpp"
#include "share/base/error.hpp"
#include "share/base/printable.hpp"
#include "share/base/text.hpp"

namespace graincrack::mesher {

namespace {

constexpr const char* known_formats =
    "a mesh of Gmsh (.msh), Neper (.msh) or Abaqus (.inp), or a picture of labels (PNG, or integers as text) is needed";

std::optional<MeshFormat> format_of(std::string_view bytes) {
    if (is_gmsh(bytes)) return MeshFormat::gmsh;
    if (is_abaqus(bytes)) return MeshFormat::abaqus;
    if (looks_like_labels(bytes)) return MeshFormat::labels;
    return std::nullopt;
}

std::string beginning(std::string_view bytes) {
    const std::string_view line = bytes.substr(0, std::min<std::size_t>(bytes.find_first_of("\r\n"), 40));
    return printable(std::string(line));
}

/// Makes the triangles of a mesh whose grains are larger grains of their phases.
ImportedMesh with_grains(ImportedMesh mesh, std::optional<GrainChoice> grains, const std::string& name) {
    if (grains == GrainChoice::physical) throw UsageError(fmt::format("--grain physical: {} has no physical groups", name));
    if (grains != GrainChoice::element) return mesh;
    std::vector<std::string> phases;
    for (int& grain : mesh.grain_of_triangle) {
        phases.push_back(mesh.phase_of_grain[static_cast<std::size_t>(grain)]);
        grain = static_cast<int>(phases.size()) - 1;
    }
    mesh.phase_of_grain = std::move(phases);
    return mesh;
}

std::string name_of_file(const ImportRequest& request) { return request.file == "-" ? "stdin" : request.file; }

MeshFormat known_format(std::string_view bytes, const ImportRequest& request) {
    const std::string name = name_of_file(request);
    if (bytes.size() > std::numeric_limits<std::int32_t>::max()) throw InputError(name + ": larger than 2 GB, which is not read");
    const auto format = request.format ? request.format : format_of(bytes);
    if (!format) throw InputError(fmt::format("{}: begins with \"{}\"; {}", name, beginning(bytes), known_formats));
    return *format;
}

LabelOptions label_options(const ImportRequest& request, const PhaseKey& key) {
    LabelOptions options = request.labels;
    if (key.is_given()) options.phases = key.of_labels();
    return options;
}

PhaseKey key_of(const ImportRequest& request) { return request.phase_key.empty() ? PhaseKey{} : PhaseKey(request.phase_key); }

}  // namespace

std::string read_bytes(const std::string& file) {
    if (file == "-") {
        std::string bytes{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
        if (bytes.empty()) throw InputError("stdin: empty: the program before wrote nothing; see its message");
        return bytes;
    }
    if (std::filesystem::is_directory(file)) throw InputError(fmt::format("{}: is a folder; {}", file, known_formats));
    std::string bytes = text_of_file(file);
    if (bytes.empty()) throw InputError(fmt::format("{}: is empty; {}", file, known_formats));
    return bytes;
}

std::vector<LabelRow> picture_labels(std::string_view bytes, const ImportRequest& request) {
    const std::string name = name_of_file(request);
    if (known_format(bytes, request) != MeshFormat::labels) {
        throw UsageError("--write-key: " + name + " is no picture; the key of a mesh has the names or numbers of its groups");
    }
    return labels_of(bytes, label_options(request, key_of(request)), name);
}

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
    switch (format) {
        case MeshFormat::labels: {
            ImportedMesh mesh = import_labels(bytes, label_options(request, key), name);
            mesh.phases = key.phases();
            return with_grains(std::move(mesh), request.grains, name);
        }
        case MeshFormat::abaqus: return imported_mesh(read_abaqus(bytes, name), request.grains, key, name);
        case MeshFormat::neper:
        case MeshFormat::gmsh: break;
    }
    return imported_mesh(read_gmsh(bytes, name), request.grains, key, name);
}

}  // namespace graincrack::mesher
