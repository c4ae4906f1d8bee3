// Counts of micro-cracks by mode.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
#include "post/table/column.hpp"

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

/// Counts by the `table_labels` but the first, whose counts are columns of their own.
using OtherCounts = std::array<ModeCounts, 3>;
/// Of the cracks of a log up to a time (s).
OtherCounts count_other_labels(const std::vector<Crack>& log, CrackEvent event, double time);

/// Their columns: tensile_cracks_by_sign, shear_cracks_by_sign, …
template <class Row>
void append_other_counts(Columns<Row>& columns, const std::function<const OtherCounts&(const Row&)>& counts_of) {
    constexpr std::array endings{"_by_sign", "_broken", "_broken_by_sign"};
    for (std::size_t i = 0; i < endings.size(); ++i) {
        columns.push_back({std::string("tensile_cracks") + endings[i], unit::none,
                           [counts_of, i](const Row& row) { return count_cell(counts_of(row)[i].tensile); }});
        columns.push_back({std::string("shear_cracks") + endings[i], unit::none,
                           [counts_of, i](const Row& row) { return count_cell(counts_of(row)[i].shear); }});
    }
}

/// Replaces the counts of a history by those of some labelled cracks.
void count_in_history(std::vector<Crack> cracks, History& history);

}  // namespace graincrack
