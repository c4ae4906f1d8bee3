// What counts as a micro-crack, and which micro-cracks are tensile.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "share/file/run_file.hpp"

namespace graincrack {

/// What tells the mode of a micro-crack.
enum class CrackModeRule {
    traction,  ///< tensile if the point passed its peak open, with a mode angle below 45°: |τ| < σn
    sign       ///< tensile if the point was open at the event that makes it a micro-crack
};
struct CrackLabel {
    CrackEvent event = CrackEvent::failed;
    CrackModeRule mode = CrackModeRule::traction;
    friend bool operator==(const CrackLabel&, const CrackLabel&) = default;
};
/// A label for any run: without an event, each run has that of its contact law.
struct CrackLabelChoice {
    std::optional<CrackEvent> event = {};
    CrackModeRule mode = CrackModeRule::traction;
    [[nodiscard]] CrackLabel of(const RunHeader& run) const { return {event.value_or(run.crack_event), mode}; }
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

/// Mode of a row of the crack log; empty if the event of the label has not happened.
std::optional<CrackMode> mode_of(const Crack& crack, const CrackLabel& label);

/// The rows of a crack log that are micro-cracks by a label, in their order, with time, opening, sliding and mode of its event.
/// Everything else is as in the log.
std::vector<Crack> labelled(const std::vector<Crack>& log, const CrackLabel& label);

/// The crack log of a run by a label. \throws InputError as `read_cracks`
std::vector<Crack> read_labelled_cracks(const RunReader& run, const Specimen& specimen, const CrackLabelChoice& label = {});

}  // namespace graincrack
