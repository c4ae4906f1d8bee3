// Kinds of rock: files of share/materials/kinds that a material of one's own begins with.
#pragma once

#include <string>
#include <vector>

namespace graincrack {

/// A kind of rock, such as "granite". Its file is a material that lacks what a laboratory measures.
struct RockKind {
    std::string name;
    std::string description;  ///< one sentence: its minerals, and whether their values rest on sources
    std::string text;         ///< of its file
};

/// The kind that a new material has unless another is named.
inline constexpr const char* usual_kind = "granite";
/// The last of the kinds, which is none: a file with every key as a comment, its unit and default.
inline constexpr const char* every_key = "every-key";

/// All kinds, by name, found beside the materials. \throws InputError if a file cannot be read or does not begin with a comment
std::vector<RockKind> rock_kinds();

/// The material file that a rock of this kind begins with; \param name of the rock
/// \throws UsageError naming --kind for an unknown kind, with the known ones
std::string material_of_kind(const std::string& kind, const std::string& name);

}  // namespace graincrack
