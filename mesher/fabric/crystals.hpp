// Crystals of several grains: what breaks within them, and what between.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// The crystals on both sides of each contact, the lower number first.
std::vector<std::pair<int, int>> crystals_of_contacts(const Specimen& specimen, std::span<const int> crystal_of_grain);

/// Says of which crystal every grain is. Contacts between grains of one crystal become contacts within it, of the class of
/// their phase: "within_quartz", named behind the classes of flaws. Contacts on flaws, also on those inside of a crystal, keep
/// their class and kind. The specimen has its phases.
void name_crystals(Specimen& specimen, std::span<const int> crystal_of_grain);

}  // namespace graincrack::mesher
