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

const std::vector<std::string>& label_columns() {
    static const std::vector<std::string> columns = [] {
        std::vector<std::string> names;
        for (const char* ending : {"_by_sign", "_broken", "_broken_by_sign"}) {
            names.push_back(std::string("tensile_cracks") + ending);
            names.push_back(std::string("shear_cracks") + ending);
        }
        return names;
    }();
    return columns;
}

std::vector<Cell> label_cells(const std::vector<Crack>& log, CrackEvent event, double time) {
    std::vector<Cell> cells;
    const std::array labels = table_labels(event);
    for (std::size_t i = 1; i < labels.size(); ++i) {
        const ModeCounts counts = count_modes(log, labels[i], time);
        cells.push_back(count_cell(counts.tensile));
        cells.push_back(count_cell(counts.shear));
    }
    return cells;
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
