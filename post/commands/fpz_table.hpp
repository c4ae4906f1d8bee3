// The fracture process zone of a rock in numbers: every quantity the paper derives, with its equation.
#pragma once

#include <iosfwd>

#include "post/table/table.hpp"
#include "share/material.hpp"

namespace graincrack {

/// Table quantity, plane, value, unit, equation (of Kazerani & Zhao 2014): Eqs 3–6, 8, 11, 14–17 and 30–44. `plane` is
/// "strain" or "stress", empty for what does not depend on it.
void write_fpz_table(std::ostream& out, const Material& material, TableFormat format);

}  // namespace graincrack
