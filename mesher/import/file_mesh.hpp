// Nodes and elements of finite-element files, and their conversion.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesher/import/imported_mesh.hpp"
#include "mesher/import/phase_key.hpp"
#include "share/base/events.hpp"

namespace graincrack::mesher {

/// Grains are elements, geometrical entities (of Gmsh; elsets of Neper) or physical groups.
enum class GrainChoice { element, entity, physical };

/// A line, a triangle or a quadrangle.
struct FileElement {
    std::int64_t number = 0;
    int n_corners = 0;                    ///< 2, 3 or 4
    std::array<std::int64_t, 4> nodes{};  ///< numbers of nodes in the file
    std::int64_t entity = 0;              ///< 0: none
    std::int64_t physical = 0;            ///< 0: none
};

struct FileMesh {
    std::string format;
    std::vector<std::int64_t> node_numbers;
    std::vector<std::array<double, 3>> positions;  ///< in the unit of the file
    std::vector<FileElement> elements;
    std::map<std::int64_t, std::string> surface_names;     ///< names of physical groups of triangles
    std::map<std::int64_t, std::string> line_names;        ///< names of physical groups of lines
    std::map<std::int64_t, std::int64_t> group_of_entity;  ///< groups of elsets in Neper
    std::string without_groups;                            ///< message if nothing gives the phases
    std::vector<Remark> notes;
};

/// Converts a name to one of a phase, part or flaw: lower-case letters, digits, _ and, between them, -.
std::string plain_name(const std::string& name);

/// Converts a file to triangles; quadrangles are divided along their shorter diagonal.
/// \param grains missing: entities, or elements if all have one entity
/// \param name of the file, for messages
/// \throws InputError if there are no such elements, or nodes are missing or outside a plane z = constant
ImportedMesh imported_mesh(const FileMesh& file, std::optional<GrainChoice> grains, const PhaseKey& key, const std::string& name);

}  // namespace graincrack::mesher
