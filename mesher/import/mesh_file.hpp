// Files of meshes from elsewhere: which format they have, and who reads it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesher/import/assemble.hpp"
#include "mesher/import/file_mesh.hpp"
#include "mesher/import/labels.hpp"

namespace graincrack::mesher {

/// Meshes of Neper are told from Gmsh's by their sections.
enum class MeshFormat { gmsh, neper, abaqus, labels };

struct ImportRequest {
    std::string file;                   ///< "-" for stdin
    std::optional<MeshFormat> format;   ///< none: told by the content
    std::optional<GrainChoice> grains;  ///< none: entities, or elements where all are of one entity
    CrystalChoice crystals = CrystalChoice::elastic;
    std::string phase_key;  ///< table of phases, "" for none
    std::string new_key;    ///< file for the key of a picture that is to be written instead of a specimen, "" for none
    LabelOptions labels;    ///< of pictures; their phases are those of the key
    Placement placement;
};

/// All bytes of a file, or of stdin for "-". \throws InputError
std::string read_bytes(const std::string& file);

/// The labels of a picture, with the phases of the key. \throws UsageError if the file is none; InputError
std::vector<LabelRow> picture_labels(std::string_view bytes, const ImportRequest& request);

/// Reads a mesh. \param bytes of the file \throws InputError naming the file, what was found and what would be right
ImportedMesh import_mesh(std::string_view bytes, const ImportRequest& request);

}  // namespace graincrack::mesher
