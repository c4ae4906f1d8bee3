// Where the nodes are between the stored frames of a run.
#pragma once

#include <cstddef>
#include <map>

#include "post/chart/map_view.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// Places a share of the way from some to others. \pre as many of both
Positions between(const Positions& from, const Positions& to, double share);

/// Reads frames as they are needed, and keeps the two about the last place.
class Motion {
public:
    Motion(const RunReader& run, const Specimen& specimen, double magnification)
        : run_(run), specimen_(specimen), magnification_(magnification) {}
    /// \param place of the frame before, and the share of the way to the next \throws InputError as `read_frame`
    Positions at(const CurvePoint& place);
    [[nodiscard]] Positions in_frame(std::size_t index) const;

private:
    const RunReader& run_;
    const Specimen& specimen_;
    double magnification_;
    std::map<std::size_t, Positions> known_;
};

}  // namespace graincrack
