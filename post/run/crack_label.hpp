// Definitions of a micro-crack in words, and the cracks and counts of a run by them.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "post/table/column.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// A label for any run: without an event, each run has that of its contact law.
struct CrackLabelChoice {
    std::optional<CrackEvent> event = {};
    CrackModeRule mode = CrackModeRule::traction;
    [[nodiscard]] CrackLabel of(const RunSettings& run) const { return {event.value_or(run.crack_event), mode}; }
};

/// The labels of tables, in their order: by the event of a run by traction and by sign, then broken by both.
constexpr std::array<CrackLabel, 4> table_labels(CrackEvent event) {
    return {{{event, CrackModeRule::traction},
             {event, CrackModeRule::sign},
             {CrackEvent::broken, CrackModeRule::traction},
             {CrackEvent::broken, CrackModeRule::sign}}};
}

/// The definition in words, for legends: "cracks: points past their peak; tensile: open, |τ| < σn at the peak".
std::string definition_of(const CrackLabel& label);

/// Counts by the `table_labels` but the first, whose counts are columns of their own.
using OtherCounts = std::array<ModeCounts, 3>;
/// The counts of the cracks of a log up to a time (s).
OtherCounts count_other_labels(const std::vector<Crack>& log, CrackEvent event, double time);

/// Their columns: tensile_cracks_by_sign, shear_cracks_by_sign, …
template <class Row>
void append_other_counts(Columns<Row>& columns, const std::function<const OtherCounts&(const Row&)>& counts_of) {
    constexpr std::array endings{"_by_sign", "_broken", "_broken_by_sign"};
    for (std::size_t i = 0; i < endings.size(); ++i) {
        columns.push_back({std::string("tensile_cracks") + endings[i], unit::none,
                           [counts_of, i](const Row& row) { return count_cell(counts_of(row)[i].tensile); }, further});
        columns.push_back({std::string("shear_cracks") + endings[i], unit::none,
                           [counts_of, i](const Row& row) { return count_cell(counts_of(row)[i].shear); }, further});
    }
}

/// Replaces the counts of a history by those of some labelled cracks.
void count_in_history(std::vector<Crack> cracks, History& history);

}  // namespace graincrack
