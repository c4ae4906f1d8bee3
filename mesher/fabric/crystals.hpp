// Names the crystals of several grains, and the contacts within them.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// [contacts] crystals on both sides, the lower number first.
std::vector<std::pair<int, int>> crystals_of_contacts(const Specimen& specimen, std::span<const int> crystal_of_grain);

/// Stores the crystal of every grain. Contacts between grains of one crystal become contacts within it, of a class per phase,
/// "within_quartz", which follows the classes of flaws. Contacts on flaws, also inside a crystal, keep their class and kind. \pre
/// the specimen has its phases
void name_crystals(Specimen& specimen, std::span<const int> crystal_of_grain);

}  // namespace graincrack::mesher
