// Makes new materials from rock types (files of share/materials/kinds), and edits values of material files.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace graincrack {

/// A rock type, such as "granite". Its file is a material without the values that a laboratory measures.
struct RockKind {
    std::string name;
    std::string description;  ///< one sentence: its minerals, and whether their values rest on sources
    std::string text;         ///< text of its file
};

/// The rock type of a new material unless another is named.
inline constexpr const char* usual_kind = "granite";
/// The last entry of the list, which is no rock type: a file with every key as a comment, with unit and default.
inline constexpr const char* every_key = "every-key";

/// All rock types by name, beside the materials. \throws InputError if a file cannot be read or does not begin with a comment
std::vector<RockKind> rock_kinds();

/// The first material file of a rock of this type. \param name of the rock
/// \throws UsageError that names --kind for an unknown type, with the known ones
std::string material_of_kind(const std::string& kind, const std::string& name);

/// A key of a material file, "contact.cohesion" or "name", and its new value: "70 MPa" or a bare SI number.
using MaterialSetting = std::pair<std::string, std::string>;

/// The text of a material file with other values. A comment on each changed line has the former value. A new key replaces its
/// example, a line `# key = …` of its table as templates have it, or else comes at the end of its table.
/// \param name_or_file as for `read_material`; the file may be incomplete \throws UsageError for an unknown key or a value that
/// does not fit it, InputError if the file cannot be read or if a key shares its line with others
std::string material_with(const std::string& name_or_file, const std::vector<MaterialSetting>& settings);

/// The text of `material_of_kind` with these values. \throws UsageError for an unknown key or a value that does not fit it
std::string new_material(const std::string& kind, const std::string& name, const std::vector<MaterialSetting>& settings);

}  // namespace graincrack
