// The parameters of σt: which of them, and their values.
#pragma once

#include "post/calibrate/progress.hpp"

namespace graincrack::calibrate {

/// The way along which σt is met: one parameter, or several that move to their bounds together.
struct TensilePath {
    struct Member {
        Parameter parameter;
        double start = 0;  ///< value at 0
        double rate = 0;   ///< change of ln value with the way
        double low = 0;
        double high = 0;
    };
    std::vector<Member> members;
    double low = 0;  ///< ends of the way
    double high = 0;
    double slope = 0;  ///< of ln σt along the way
    /// `base` with the values at a place of the way; the shear strength of open contacts keeps its ratio to what follows from tc.
    [[nodiscard]] Point point(const Material& rock, const Point& base, double way) const;
};
/// Chooses the parameters of σt and sets them near. \throws RunsMissing, Ended
TensilePath find_tensile_path(Progress& progress, double& way);
/// Adjusts them with many discs at the present cc and φc. \throws RunsMissing, Ended
void adjust_tensile(Progress& progress, TensilePath& path, double& way, std::int64_t first_seed);

}  // namespace graincrack::calibrate
