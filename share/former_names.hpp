// Names that datasets and attributes had in files of former schema versions, and texts that attributes had. `H5Input` looks them
// up, so that everything else knows the names of today only.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace graincrack {

/// Name under which a file of a schema version holds a dataset or an attribute.
/// \param group path of the group or object that it belongs to, "/history"
/// \param name name of today; returned unchanged unless the file has another one
std::string_view stored_name(std::int64_t version, std::string_view group, std::string_view name);

/// Names of today and former ones of what a group holds. Those of `/history` stay as links, for scripts that know them.
std::vector<std::pair<std::string_view, std::string_view>> former_names_of(std::string_view group);

/// The text of today for a text that an attribute of a file of a schema version has.
/// \param attribute name of today
std::string_view present_text(std::int64_t version, std::string_view group, std::string_view attribute, std::string_view text);

}  // namespace graincrack
