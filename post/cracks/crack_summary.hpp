// The crack log of a run in one row: modes, separation, events, fragments.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/cracks/crack_counts.hpp"
#include "post/cracks/emission.hpp"
#include "post/cracks/fragments.hpp"
#include "post/run/load_curve.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Contacts (points ÷ 2) up to some time.
struct CrackBalance : ModeCounts {
    double separated = 0;  ///< of both, those without any strength left then
};
/// \param cracks labelled ones
CrackBalance balance_cracks(const std::vector<Crack>& cracks, double time);

/// The rows of a crack log, and what they belong to.
struct CrackRows {
    const std::vector<Crack>& all;
    const Specimen& specimen;
    CrackLabel label;  ///< of the modes, of separation and of directions
};

/// Table: one row at the peak, if there is a curve, one at the end. Emission and fragments are given in the row of the end only.
void write_crack_summary(std::ostream& out, const RunData& run, const std::optional<LoadCurve>& curve, const CrackRows& log,
                         const std::vector<EmissionEvent>& events, const Fragments& fragments, TableFormat format);

}  // namespace graincrack
