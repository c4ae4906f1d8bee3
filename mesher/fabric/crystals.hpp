// Crystals of several grains: what breaks within them, and what between.
#pragma once

#include <span>

#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Says of which crystal every grain is. Contacts between grains of one crystal become contacts within it, of the class of
/// their phase: "within_quartz", named behind the classes of flaws, whose contacts keep theirs. The specimen has its phases.
void name_crystals(Specimen& specimen, std::span<const int> crystal_of_grain);

}  // namespace graincrack::mesher
