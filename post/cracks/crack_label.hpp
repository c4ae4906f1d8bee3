// What counts as a micro-crack, and which micro-cracks are tensile.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "share/run_file.hpp"

namespace graincrack {

/// The event by which a contact point becomes a micro-crack.
enum class CrackEvent {
    failed,  ///< it passed its peak
    broken   ///< less than 10 % of its cohesion was left
};
/// What tells the mode of a micro-crack at that event.
enum class CrackModeRule {
    sign,         ///< tensile if the point was open
    displacement  ///< tensile if it had opened more than it had slid
};
struct CrackLabel {
    CrackEvent event = CrackEvent::failed;
    CrackModeRule mode = CrackModeRule::sign;
    friend bool operator==(const CrackLabel&, const CrackLabel&) = default;
};

/// The four labels, in the order in which tables show them: failed by sign and by displacement, then broken.
inline constexpr CrackLabel all_crack_labels[] = {{CrackEvent::failed, CrackModeRule::sign},
                                                  {CrackEvent::failed, CrackModeRule::displacement},
                                                  {CrackEvent::broken, CrackModeRule::sign},
                                                  {CrackEvent::broken, CrackModeRule::displacement}};

/// The definition in words, for legends: "cracks: points past their peak; tensile: open then".
std::string definition_of(const CrackLabel& label);

/// Mode of a row of the crack log; empty if the event of the label has not happened.
std::optional<CrackMode> mode_of(const Crack& crack, const CrackLabel& label);

/// The rows that are micro-cracks by a label, in their order, with time, opening, sliding and mode of its event. Everything else
/// is as in the log.
std::vector<Crack> labelled(const std::vector<Crack>& cracks, const CrackLabel& label);

/// The crack log of a run by a label. \throws InputError as `read_cracks`
std::vector<Crack> read_labelled_cracks(const RunReader& run, const Specimen& specimen, const CrackLabel& label);

}  // namespace graincrack
