// The columns of all tables, as share/doc/tables.md has them.
#pragma once

#include <string_view>
#include <vector>

#include "share/options/command_line.hpp"

namespace graincrack {

/// The tables of a page in the form of tables.md: each stands behind the heading of its command, names that share a meaning in
/// one row, alternatives of a part of a name in braces.
std::vector<TableRow> tables_of_page(std::string_view page);
/// Those of tables.md, and the history.
std::vector<TableRow> documented_tables();

}  // namespace graincrack
