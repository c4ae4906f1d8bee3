// The columns of all tables, as share/doc/columns.tsv has them.
#pragma once

#include <string_view>
#include <vector>

#include "share/options/command_line.hpp"

namespace graincrack {

/// The tables of rows in the form of columns.tsv: command, file, columns and their meaning, behind a line of names. Columns that
/// share a meaning stand in one row, alternatives of a part of a name in braces.
std::vector<TableRow> tables_of_rows(std::string_view rows);
/// Those of columns.tsv, and the history.
std::vector<TableRow> documented_tables();

}  // namespace graincrack
