// Splitting of a Brazilian disc: whether the largest load is that of the split, and whether the split began near the centre.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/measure/caveat.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

struct BrazilianSplit {
    /// 2F/(π t D) when the open cracks of one network (linked by closed ones too) first span `spanning_share` of the
    /// diameter along the load, Pa; empty if they never do.
    std::optional<double> spanning_stress;
    /// Mean distance of the first open cracks (the first 5 % of those at the peak, two points at least) from the centre
    /// over the radius; empty without any.
    std::optional<double> first_crack_radius;
    /// Why 2Fmax/(π t D) may not be the tensile strength.
    std::vector<Caveat> caveats;
    /// Their texts in one; empty if there are none.
    [[nodiscard]] std::string warning() const;
};
inline constexpr double spanning_share = 0.8;

/// What splits a disc is what opens, whatever traction it began with: cracks are points past their peak, told by the sign of
/// opening. \param log crack log of the run, in any order
BrazilianSplit measure_split(const RunData& run, const LoadCurve& curve, const Specimen& specimen, const std::vector<Crack>& log);

}  // namespace graincrack
