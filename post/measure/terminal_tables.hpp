// The tables `strength`, `strength --summary` and `moduli` as terminal tables, from the rows of those for scripts.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/table/table.hpp"

namespace graincrack {

/// Rows of a table for scripts with the names of their columns.
struct ScriptTable {
    const std::vector<std::string>& columns;
    const std::vector<std::vector<Cell>>& rows;
};

/// Strength, strain and cracks of each run, in groups of one test, pressure and plane condition, each with its mean.
void write_strengths_to_terminal(std::ostream& out, const ScriptTable& table);
/// The rows of `strength --summary`.
void write_summary_to_terminal(std::ostream& out, const ScriptTable& table);
/// E and ν by gauges, by platens and predicted, in groups of one plane condition.
void write_moduli_to_terminal(std::ostream& out, const ScriptTable& table);

}  // namespace graincrack
