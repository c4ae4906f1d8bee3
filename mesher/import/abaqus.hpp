// Input files of Abaqus (.inp), as Gmsh, Neper and FDEM codes write them.
#pragma once

#include <string>
#include <string_view>

#include "mesher/import/file_mesh.hpp"

namespace graincrack::mesher {

/// Whether bytes begin as such a file does: with a keyword such as *Heading or *Node, or a comment.
bool is_abaqus(std::string_view bytes);

/// Reads *Node, *Element and *Elset (with `generate`) of a file with one part; other keywords are passed over.
///
/// Grains are elsets whose names are a word and a number (face12, Surface3, GRAIN_7). Phases are the other elsets of
/// triangles and quadrangles, without ELSET_ or PHASE_ before their names; sets of all elements are none. Lines (T2D2, T3D2, B21
/// and their like) have the names of their elsets. \param name for messages \throws InputError naming the file, the line, what
/// was found and what would be right
FileMesh read_abaqus(std::string_view bytes, const std::string& name);

}  // namespace graincrack::mesher
