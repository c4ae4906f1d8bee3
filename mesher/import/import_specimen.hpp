// Makes a specimen from a file of another program: the interface of the importer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/fabric/fabric.hpp"
#include "mesher/import/assemble.hpp"
#include "mesher/import/file_mesh.hpp"
#include "mesher/import/labels.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Format of a file; sections distinguish meshes of Neper from those of Gmsh.
enum class MeshFormat { gmsh, neper, labels };

struct ImportRequest {
    std::string file;                   ///< "-" for stdin
    std::optional<MeshFormat> format;   ///< missing: found from the content
    std::optional<GrainChoice> grains;  ///< missing: entities, or elements if all have one entity
    CrystalChoice crystals = CrystalChoice::elastic;
    std::string phase_key;  ///< table of phases, "" for none
    std::string new_key;    ///< file for a new key of a picture, which replaces the specimen; "" for none
    LabelOptions labels;    ///< for pictures; their phases are those of the key
    Placement placement;
};

/// Reads a mesh. \param bytes of the file \throws InputError naming the file, what was found and what would be right
ImportedMesh import_mesh(std::string_view bytes, const ImportRequest& request);

struct Import {
    Specimen specimen;
    std::string digest;            ///< SHA-256 of the file
    std::string format;            ///< "Gmsh 4.1, binary"
    std::vector<LabelRow> labels;  ///< of a picture
    std::vector<Remark> notes;     ///< decisions, one per line; warnings of errors

    /// True if the file has the phases of its grains.
    [[nodiscard]] bool has_phases() const { return specimen.phase_names != Specimen{}.phase_names; }
};

/// Reads a file into a specimen. Its crystals get phases, if the file has none, scattered strengths and open boundaries. \throws
/// InputError naming the file, what was found and what would be right; UsageError if both the file and options have phases
Import import_specimen(const ImportRequest& request, Fabric fabric, std::uint64_t seed);

/// Writes a key of the labels of a picture, in which phases are to be entered, to a file. \return the labels, one per line
/// \throws UsageError if the file exists and is not the key of the request
std::vector<std::string> write_new_key(const ImportRequest& request);

/// Describes the result, one line each, with warnings of errors. Lengths in mm, angles in degrees.
std::vector<Remark> describe(const Import& import);

}  // namespace graincrack::mesher
