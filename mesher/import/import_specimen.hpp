// A specimen from a file of another program: the interface of the importer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesher/fabric/fabric.hpp"
#include "mesher/import/mesh_file.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

struct Import {
    Specimen specimen;
    std::string digest;              ///< SHA-256 of the file
    std::string format;              ///< "Gmsh 4.1, binary"
    std::vector<LabelRow> labels;    ///< of a picture
    std::vector<std::string> notes;  ///< what was decided, a line each

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

/// What came out, a line each. Lengths in mm, angles in degrees.
std::vector<std::string> describe(const Import& import);

}  // namespace graincrack::mesher
