#include "post/run/mode_counts.hpp"

#include <algorithm>
#include <array>

namespace graincrack {

ModeCounts count_modes(const std::vector<Crack>& log, const CrackLabel& label, double time) {
    ModeCounts counts;
    for (const Crack& crack : labelled(log, label)) {
        if (crack.time <= time) counts.add(crack);
    }
    return counts;
}

OtherCounts count_other_labels(const std::vector<Crack>& log, CrackEvent event, double time) {
    OtherCounts counts;
    const std::array labels = table_labels(event);
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = count_modes(log, labels[i + 1], time);
    return counts;
}

void count_in_history(std::vector<Crack> cracks, History& history) {
    std::stable_sort(cracks.begin(), cracks.end(), [](const Crack& a, const Crack& b) { return a.time < b.time; });
    ModeCounts now;
    auto next = cracks.begin();
    for (std::size_t row = 0; row < history.size(); ++row) {
        for (; next != cracks.end() && next->time <= history[HistoryColumn::time][row]; ++next) now.add(*next);
        history[HistoryColumn::tensile_cracks][row] = now.tensile;
        history[HistoryColumn::shear_cracks][row] = now.shear;
    }
}

}  // namespace graincrack
