// Splitting of a Brazilian disc: whether the largest load is that of the split, and whether the split began near the centre.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/run/load_curve.hpp"

namespace graincrack {

/// A caveat: a reason to doubt the strength of a test.
struct Caveat {
    std::string code;  ///< of its warning, as of `Remark`
    std::string kind;  ///< without numbers, so that the runs that have it can be counted: "first cracks outside 0.5 R"
    std::string text;  ///< with them: "first cracks at 0.81 R, not inside 0.5 R"
};

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

/// True if a run is to split a disc. A ring breaks from its hole.
bool splits(const RunData& run);

/// Tensile strength by Griffith's criterion at the centre of a disc, over 2F/(π t D), where an even pressure acts on arcs seen
/// under this angle: (sin ψ/ψ)² (stresses of Hondros 1959). With flat poles of 20° it is 0.96; Wang et al. (2004) have 0.95.
double strength_share_of_arcs(double angle);

/// Open cracks split a disc, whatever traction they began with: cracks are points past their peak, tensile by the sign of the
/// opening. \param log crack log of the run, in any order
BrazilianSplit measure_split(const RunData& run, const LoadCurve& curve, const Specimen& specimen, const std::vector<Crack>& log);

}  // namespace graincrack
