// Nodes and elements as finite-element files have them, and what is taken of them.
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

/// What is one grain: an element, a geometrical entity (of Gmsh; the elset of Neper) or a physical group.
enum class GrainChoice { element, entity, physical };

/// A line, a triangle or a quadrangle.
struct FileElement {
    std::int64_t number = 0;
    int n_corners = 0;                    ///< 2, 3 or 4
    std::array<std::int64_t, 4> nodes{};  ///< by their numbers in the file
    std::int64_t entity = 0;              ///< 0: none
    std::int64_t physical = 0;            ///< 0: none
};

struct FileMesh {
    std::string format;
    std::vector<std::int64_t> node_numbers;
    std::vector<std::array<double, 3>> positions;  ///< in the unit of the file
    std::vector<FileElement> elements;
    std::map<std::int64_t, std::string> surface_names;     ///< of physical groups of triangles
    std::map<std::int64_t, std::string> line_names;        ///< of physical groups of lines
    std::map<std::int64_t, std::int64_t> group_of_entity;  ///< of Neper
    std::string without_groups;                            ///< what to say if nothing gives the phases
    std::vector<Remark> notes;
};

/// A name as one of a phase, a part or a flaw: small letters, digits, _ and, between them, -.
std::string plain_name(const std::string& name);

/// Triangles of a file: quadrangles are divided along their shorter diagonal.
/// \param grains none: entities, or elements where all are of one entity
/// \param name of the file, for messages
/// \throws InputError if there are no such elements, nodes are missing or lie beside a plane z = constant
ImportedMesh imported_mesh(const FileMesh& file, std::optional<GrainChoice> grains, const PhaseKey& key, const std::string& name);

}  // namespace graincrack::mesher
