// The table `properties` of a rock: its specimens beside its laboratory (the paper's Table 8), and what its kind predicts.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/laboratory/comparison.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// E and ν (chord to half the peak) of the uniaxial tests, tensile strengths, σ1 at each pressure, and C, φ and b of the line
/// through them, also by the stress at first yield; then, without runs, what the surface of the kind predicts of new specimens:
/// σ1 at the pressures of the runs, of [targets] and of the laboratory, else at 8 and 20 MPa. Neither the runs nor the kind need
/// to give all. \param why the kind predicts nothing; "" if it does \throws InputError as require_comparable and
/// collect_envelope_tests, and for a broken table or [targets]
std::vector<ComparisonRow> property_rows(const std::vector<RunData>& runs, IncompleteMaterial material,
                                         const EnvelopeOptions& options, std::string& why);

/// Table property, laboratory, published, ours, low, high, deviation, specimens, without_peak, off_laboratory_percent,
/// half_interval_percent, specimens_for_3_percent, kind_median, kind_50_low, kind_50_high, kind_95_low, kind_95_high; each row in
/// the unit of its name.
void write_properties(std::ostream& out, const std::vector<ComparisonRow>& rows, TableFormat format);

}  // namespace graincrack
