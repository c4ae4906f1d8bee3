#include "post/cracks/crack_label.hpp"

#include <cmath>

#include "post/cracks/run_state.hpp"

namespace graincrack {

std::string definition_of(const CrackLabel& label) {
    const std::string event =
        label.event == CrackEvent::failed ? "cracks: points past their peak" : "cracks: < 10 % of cohesion left";
    return event + (label.mode == CrackModeRule::sign ? "; tensile: open then" : "; tensile: opened more than slid");
}

std::optional<CrackMode> mode_of(const Crack& crack, const CrackLabel& label) {
    const bool broken = label.event == CrackEvent::broken;
    if (broken && std::isnan(crack.time_broken)) return std::nullopt;
    if (label.mode == CrackModeRule::sign && !broken) return crack.mode;
    const double opening = broken ? crack.opening_broken : crack.opening;
    const double sliding = broken ? crack.sliding_broken : crack.sliding;
    const bool tensile = label.mode == CrackModeRule::sign ? opening >= 0 : opening > std::abs(sliding);
    return tensile ? CrackMode::tensile : CrackMode::shear;
}

std::vector<Crack> labelled(const std::vector<Crack>& cracks, const CrackLabel& label) {
    std::vector<Crack> found;
    for (Crack crack : cracks) {
        const std::optional<CrackMode> mode = mode_of(crack, label);
        if (!mode) continue;
        crack.mode = *mode;
        if (label.event == CrackEvent::broken) {
            crack.time = crack.time_broken;
            crack.opening = crack.opening_broken;
            crack.sliding = crack.sliding_broken;
        }
        found.push_back(crack);
    }
    return found;
}

std::vector<Crack> read_labelled_cracks(const RunReader& run, const Specimen& specimen, const CrackLabel& label) {
    return labelled(read_cracks(run, specimen), label);
}

}  // namespace graincrack
