// A specimen from a file of another program: the interface of the importer.
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

/// Meshes of Neper are told from Gmsh's by their sections.
enum class MeshFormat { gmsh, neper, labels };

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

/// Reads a mesh. \param bytes of the file \throws InputError naming the file, what was found and what would be right
ImportedMesh import_mesh(std::string_view bytes, const ImportRequest& request);

struct Import {
    Specimen specimen;
    std::string digest;            ///< SHA-256 of the file
    std::string format;            ///< "Gmsh 4.1, binary"
    std::vector<LabelRow> labels;  ///< of a picture
    std::vector<Remark> notes;     ///< what was decided, a line each; warnings where something is wrong

    /// Whether the file says of what phases its grains are.
    [[nodiscard]] bool has_phases() const { return specimen.phase_names != Specimen{}.phase_names; }
};

/// Reads a file and makes it a specimen, whose crystals get phases, if the file has none, scattered strengths and open
/// boundaries. \throws InputError naming the file, what was found and what would be right; UsageError if the file has phases and
/// options give
///         others
Import import_specimen(const ImportRequest& request, Fabric fabric, std::uint64_t seed);

/// Writes a key of the labels of a picture, whose phases are to be named, to a file. \return the labels, a line each
/// \throws UsageError if there is such a file, which is not the key of the request
std::vector<std::string> write_new_key(const ImportRequest& request);

/// What came out, a line each: warnings where something is wrong. Lengths in mm, angles in degrees.
std::vector<Remark> describe(const Import& import);

}  // namespace graincrack::mesher
