#include "post/run/crack_label.hpp"

#include <cmath>
#include <numbers>

#include "post/run/run_state.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace {

CrackMoment moment_of(const Crack& crack, CrackEvent event) {
    switch (event) {
        case CrackEvent::failed: return {crack.time, crack.opening, crack.sliding};
        case CrackEvent::half_damaged: return crack.damaged_50;
        default: return crack.broken;
    }
}

std::string words_of(CrackEvent event) {
    return name_in({"points past their peak", "< 50 % of cohesion left", "< 10 % of cohesion left"}, event);
}

}  // namespace

std::string definition_of(const CrackLabel& label) {
    return "cracks: " + words_of(label.event) +
           (label.mode == CrackModeRule::sign ? "; tensile: open then" : "; tensile: open, |τ| < σn at the peak");
}

std::optional<CrackMode> mode_of(const Crack& crack, const CrackLabel& label) {
    const CrackMoment moment = moment_of(crack, label.event);
    if (std::isnan(moment.time)) return std::nullopt;
    const bool tensile =
        label.mode == CrackModeRule::sign ? moment.opening >= 0 : crack.opening >= 0 && crack.mode_angle < std::numbers::pi / 4;
    return tensile ? CrackMode::tensile : CrackMode::shear;
}

std::vector<Crack> labelled(const std::vector<Crack>& log, const CrackLabel& label) {
    std::vector<Crack> found;
    for (Crack crack : log) {
        const std::optional<CrackMode> mode = mode_of(crack, label);
        if (!mode) continue;
        const CrackMoment moment = moment_of(crack, label.event);
        crack.mode = *mode;
        crack.time = moment.time;
        crack.opening = moment.opening;
        crack.sliding = moment.sliding;
        found.push_back(crack);
    }
    return found;
}

std::vector<Crack> read_labelled_cracks(const RunReader& run, const Specimen& specimen, const CrackLabelChoice& label) {
    return labelled(read_cracks(run, specimen), label.of(run.header()));
}

}  // namespace graincrack
