// Counts of micro-cracks by mode.
#pragma once

#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Contacts (points ÷ 2) with tensile and with shear cracks.
struct ModeCounts {
    double tensile = 0;
    double shear = 0;
    void add(const Crack& crack) { (crack.mode == CrackMode::tensile ? tensile : shear) += 0.5; }
    ModeCounts& operator+=(const ModeCounts& other) {
        tensile += other.tensile;
        shear += other.shear;
        return *this;
    }
};

/// Cracks of a log by a label, up to a time (s).
ModeCounts count_modes(const std::vector<Crack>& log, const CrackLabel& label, double time);

/// Columns of tables of runs, behind those of `tensile_cracks` and `shear_cracks`: the counts by the other `table_labels`.
const std::vector<std::string>& label_columns();
/// Their entries at a time (s).
std::vector<Cell> label_cells(const std::vector<Crack>& log, CrackEvent event, double time);

/// Replaces the counts of a history by those of some labelled cracks.
void count_in_history(std::vector<Crack> cracks, History& history);

}  // namespace graincrack
