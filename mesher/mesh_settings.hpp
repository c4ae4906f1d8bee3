// The settings of a specimen that are more than the value of one option.
#pragma once

#include "mesher/fabric/fabric.hpp"
#include "share/file/settings.hpp"

namespace graincrack::mesher {

/// Adds the sizes that are graded, the phases with their fractions, the outline of a polygon, holes, flaws and sets of joints.
/// Coordinates are those of the centred region, m; relative to the options of one value, such as --slit, nothing stands twice.
void add_settings(const Request& request, Settings& settings);

}  // namespace graincrack::mesher
