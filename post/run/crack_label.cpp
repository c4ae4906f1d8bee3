#include "post/run/crack_label.hpp"

#include <algorithm>

#include "share/base/text.hpp"

namespace graincrack {

namespace {

std::string words_of(CrackEvent event) {
    return name_in({"points past their peak", "< 50 % of cohesion left", "< 10 % of cohesion left"}, event);
}

}  // namespace

std::string definition_of(const CrackLabel& label) {
    return "cracks: " + words_of(label.event) +
           (label.mode == CrackModeRule::sign ? "; tensile: open then" : "; tensile: open, |τ| < σn at the peak");
}

OtherCounts count_other_labels(const std::vector<Crack>& log, CrackEvent event, double time) {
    OtherCounts counts;
    const std::array labels = table_labels(event);
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = count_modes(log, labels[i + 1], time);
    return counts;
}

void count_in_history(std::vector<Crack> cracks, History& history) {
    std::ranges::stable_sort(cracks, [](const Crack& a, const Crack& b) { return a.time < b.time; });
    ModeCounts now;
    auto next = cracks.begin();
    for (std::size_t row = 0; row < history.size(); ++row) {
        for (; next != cracks.end() && next->time <= history[HistoryColumn::time][row]; ++next) now.add(*next);
        history[HistoryColumn::tensile_cracks][row] = now.tensile;
        history[HistoryColumn::shear_cracks][row] = now.shear;
    }
}

}  // namespace graincrack
