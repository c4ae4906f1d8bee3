// State of a contact point, mode and event of a micro-crack, as the solver's laws and the files number them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace graincrack {

/// State of a contact point (dataset /frames/NNNN/state).
enum class PointState : std::uint8_t { intact = 0, failed_tension = 1, failed_shear = 2, separated = 3 };
/// Mode of a micro-crack (dataset /cracks/mode).
enum class CrackMode : std::uint8_t { tensile = 0, shear = 1 };
/// The event by which a contact point becomes a micro-crack.
enum class CrackEvent : std::uint8_t {
    failed,        ///< it passed its peak
    half_damaged,  ///< less than 50 % of its cohesion was left
    broken         ///< less than 10 % of its cohesion was left
};
inline constexpr std::array all_crack_events{CrackEvent::failed, CrackEvent::half_damaged, CrackEvent::broken};
/// As options and files (attribute crack_event of /run) spell it.
constexpr std::string_view name_of(CrackEvent event) {
    switch (event) {
        case CrackEvent::failed: return "failed";
        case CrackEvent::half_damaged: return "half-damaged";
        default: return "broken";
    }
}

}  // namespace graincrack
