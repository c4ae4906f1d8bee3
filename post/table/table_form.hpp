// Who a table is for: people or scripts.
#pragma once

#include <optional>
#include <ostream>

#include "post/table/table.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): a name of CLI11
class App;
}

namespace graincrack {

/// A terminal table, one of the formats for scripts, or, `automatic`, a terminal table on a terminal and TSV elsewhere.
enum class TableForm { automatic, table, tsv, jsonl };
/// --format table|tsv|jsonl
void add_form(CLI::App& app, TableForm& form);
/// The format for scripts; empty for a terminal table. Automatic: empty where `out` is a terminal, else TSV.
std::optional<TableFormat> format_of(TableForm form, const std::ostream& out);

}  // namespace graincrack
