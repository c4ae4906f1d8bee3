// Files of a rectangle of 2 × 1, in each format: two squares of two triangles each, quartz at the left, feldspar at the right.
//
//     4───5───6       entities (grains) 7 and 9, physical groups 1 and 2;
//     │ ╱ │ ╱ │       the line between 2 and 5 is a crack, the right side has the name "loaded"
//     1───2───3
#pragma once

#include <string>

#include "mesher/import/import_specimen.hpp"
#include "share/base/text.hpp"

namespace graincrack::mesher {

inline const std::string msh_22 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n4\n2 1 \"Quartz\"\n2 2 \"feld spar\"\n1 3 \"crack\"\n1 4 \"Loaded\"\n$EndPhysicalNames\n"
    "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
    "$Elements\n7\n1 15 2 0 1 1\n2 1 2 3 1 2 5\n3 1 2 4 2 3 6\n"
    "4 2 2 1 7 1 2 5\n5 2 2 1 7 1 5 4\n6 2 2 2 9 2 3 6\n7 2 2 2 9 2 6 5\n$EndElements\n";

inline const std::string msh_41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n4\n2 1 \"Quartz\"\n2 2 \"feld spar\"\n1 3 \"crack\"\n1 4 \"Loaded\"\n$EndPhysicalNames\n"
    "$Entities\n1 2 2 0\n1 0 0 0 0\n1 1 0 0 1 1 0 1 3 0\n2 2 0 0 2 1 0 1 4 0\n7 0 0 0 1 1 0 1 1 1 1\n9 1 0 0 2 1 0 1 2 0\n"
    "$EndEntities\n"
    "$Nodes\n2 6 1 6\n2 7 0 4\n1\n2\n4\n5\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 9 1 2\n3\n6\n2 0 0 .1 .2\n2 1 0 .3 .4\n$EndNodes\n"
    "$Elements\n4 6 1 6\n1 1 1 1\n1 2 5\n1 2 1 1\n2 3 6\n2 7 2 2\n3 1 2 5\n4 1 5 4\n2 9 2 2\n5 2 3 6\n6 2 6 5\n$EndElements\n";

inline const std::string neper_msh = text_of_file(GRAINCRACK_TEST_DATA "/meshes/two-squares-neper.msh");

/// The mesh of a file; `request` says the rest.
inline ImportedMesh read_mesh(const std::string& bytes, ImportRequest request = {}) {
    request.file = "file";
    return import_mesh(bytes, request);
}

}  // namespace graincrack::mesher
