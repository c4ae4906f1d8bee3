// Settings of a specimen that are not single option values.
#pragma once

#include "mesher/fabric/fabric.hpp"
#include "share/file/settings.hpp"

namespace graincrack::mesher {

/// Adds graded sizes, phases with fractions, the outline of a polygon, holes, flaws and sets of joints. Coordinates are those of
/// the centred region, m. Values of single options, such as --slit, are not repeated.
void add_settings(const Request& request, Settings& settings);

}  // namespace graincrack::mesher
