// The crack log (/cracks of a run file), and the definitions by which its rows are micro-cracks.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "share/file/h5_file.hpp"
#include "share/rock/contact_state.hpp"

namespace graincrack {

/// Time of an event of a contact point, and its relative displacement at the end of that step; NaN without the event.
struct CrackMoment {
    double time = std::numeric_limits<double>::quiet_NaN();     ///< s
    double opening = std::numeric_limits<double>::quiet_NaN();  ///< m
    double sliding = std::numeric_limits<double>::quiet_NaN();  ///< m
    friend bool operator==(const CrackMoment&, const CrackMoment&) = default;
};

/// One row of the crack log: a contact point that passed its peak strength. Other values are those of this step unless stated.
struct Crack {
    double time = 0;  ///< s
    std::int64_t step = 0;
    std::int32_t contact = 0;  ///< row of /contacts
    std::uint8_t point = 0;    ///< 0 at a1, 1 at a2
    CrackMode mode = CrackMode::tensile;
    double mode_angle = 0;             ///< atan2(|τ|, σn) in the step before, the last before the peak, rad
    std::array<double, 2> position{};  ///< m
    double orientation = 0;            ///< angle of the tangent from x, counter-clockwise, rad, in [0, π)
    double length = 0;                 ///< half of the edge's length, m
    double opening = 0;                ///< m
    double sliding = 0;                ///< m
    double energy_released = 0;        ///< fracture energy dissipated by this point until the end of the run, J
    CrackMoment damaged_10 = {};       ///< 10 % of its cohesion is lost
    CrackMoment damaged_50 = {};       ///< 50 % is lost
    CrackMoment broken = {};           ///< 90 % is lost
    CrackMoment separated = {};        ///< all tensile strength is lost
};

/// The criterion for the mode of a micro-crack.
enum class CrackModeRule {
    traction,  ///< tensile if the point was open at failure, with a mode angle below 45°: |τ| < σn
    sign       ///< tensile if the point was open at the event that makes it a micro-crack
};
struct CrackLabel {
    CrackEvent event = CrackEvent::failed;
    CrackModeRule mode = CrackModeRule::traction;
    friend bool operator==(const CrackLabel&, const CrackLabel&) = default;
};
/// Mode of a row of the crack log; empty if the event of the label has not happened.
std::optional<CrackMode> mode_of(const Crack& crack, const CrackLabel& label);

/// The rows of a crack log that are micro-cracks by a label, in order, with time, opening, sliding and mode of its event. Other
/// members are as in the log.
std::vector<Crack> labelled(const std::vector<Crack>& log, const CrackLabel& label);

/// Numbers of contacts (points ÷ 2) with tensile and with shear cracks.
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

/// Counts the cracks of a log by a label, up to a time (s).
ModeCounts count_modes(const std::vector<Crack>& log, const CrackLabel& label, double time);

void write_cracks(H5Output& file, const std::vector<Crack>& cracks);
/// Reads the crack log. \throws InputError if it is damaged
std::vector<Crack> read_cracks(const H5Input& file);

}  // namespace graincrack
