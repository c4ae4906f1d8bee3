// The crack log of a run in one row: modes, tensile cracks that also slid, separation, events, fragments.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/cracks/emission.hpp"
#include "post/cracks/fragments.hpp"
#include "post/measure/load_curve.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Contacts (points ÷ 2) up to some time.
struct CrackBalance {
    double tensile = 0;
    double shear = 0;
    double separated = 0;             ///< of both, those without any strength left then
    double tensile_more_sliding = 0;  ///< tensile ones that had slid more than they had opened when they failed
    double tensile_by_traction = 0;   ///< of all, those with |τ| < σn at the peak: mode angle below 45°
    [[nodiscard]] std::optional<double> share_more_sliding() const;
};
CrackBalance balance_cracks(const std::vector<Crack>& cracks, double time);

/// The rows of a crack log, and what they belong to.
struct CrackRows {
    const std::vector<Crack>& all;
    const Specimen& specimen;
};

/// Table: one row at the peak, if there is a curve, one at the end. Emission and fragments are given in the row of the end only.
void write_crack_summary(std::ostream& out, const RunData& run, const std::optional<LoadCurve>& curve, const CrackRows& cracks,
                         const std::vector<EmissionEvent>& events, const Fragments& fragments, TableFormat format);

}  // namespace graincrack
