// Crystals of several grains: what breaks within them, and what between.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// The crystals on both sides of each contact, those of its first and its second grain.
std::vector<std::array<int, 2>> crystals_of_contacts(const Specimen& specimen, std::span<const int> crystal_of_grain);

/// Says of which crystal every grain is. Contacts between grains of one crystal become contacts within it, of the class of
/// their phase: "within_quartz", named behind the classes of flaws. Contacts on flaws, also on those inside of a crystal, keep
/// their class and kind. The specimen has its phases.
void name_crystals(Specimen& specimen, std::span<const int> crystal_of_grain);

/// The number of crystals: of grains where each is one.
std::size_t number_of_crystals(const Specimen& specimen);

/// Mean equal-area diameter of crystals, m.
double mean_crystal_diameter(const Specimen& specimen);

/// What to say of a specimen with fewer than ten crystals of the mean equal-area diameter across its smaller extent; "" of
/// others. Its strengths depend on single crystals.
std::string note_on_few_crystals(const Specimen& specimen);

}  // namespace graincrack::mesher
