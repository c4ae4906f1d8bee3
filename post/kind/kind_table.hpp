// The surface of a kind as tables.
#pragma once

#include <ostream>
#include <vector>

#include "post/kind/kind_surface.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// A row of each term of each property: property, term, coefficient, standard_error of ln, then of the property scatter,
/// rock_deviation, prediction_error, specimens.
void write_kind_terms(std::ostream& out, const KindSurface& surface, TableFormat format);

/// A row of each value of a calibrated rock, which is not in the fit: rock, property, confining_pressure, measured, predicted
/// (over tc), specimens, off_percent of the prediction from the value, and low_percent, high_percent, its 95 % interval by the
/// scatter of specimens and the fit alone. Beyond the design nothing is predicted.
void write_kind_rocks(std::ostream& out, const KindSurface& surface, const std::vector<KindRow>& rows, TableFormat format);

}  // namespace graincrack
