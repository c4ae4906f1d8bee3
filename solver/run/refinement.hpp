// The same grains of smaller elements.
#pragma once

#include "share/file/specimen.hpp"

namespace graincrack {

/// Divides every element into four by the middles of its sides, every contact and boundary edge into two. Grains, outline and
/// statistics stay; nodes of the old specimen keep their numbers.
Specimen refined(const Specimen& specimen);

}  // namespace graincrack
