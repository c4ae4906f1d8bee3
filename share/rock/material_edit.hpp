// Kinds of rock, files of share/materials/kinds that a material of one's own begins with; and a material file with other values,
// its comments kept.
#pragma once

#include <string>
#include <utility>
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

/// A key of a material file, "contact.cohesion" or "name", and its new value: "70 MPa" or a bare SI number.
using MaterialSetting = std::pair<std::string, std::string>;

/// The text of a material file with other values. A comment on each changed line has the former value; a key that the file does
/// not have comes in place of its example, a line `# key = …` of its table as templates have it, else at the end of its table.
/// \param name_or_file as of `read_material`; the file may be incomplete \throws UsageError for an unknown key or a value that
/// does not fit it, InputError if the file cannot be read, or a key shares
///         its line with others
std::string material_with(const std::string& name_or_file, const std::vector<MaterialSetting>& settings);

/// The file of a new material of a kind of rock, as `material_of_kind` has it, in which values have been entered. \throws
/// UsageError for an unknown key or a value that does not fit it
std::string new_material(const std::string& kind, const std::string& name, const std::vector<MaterialSetting>& settings);

}  // namespace graincrack
