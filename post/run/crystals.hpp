// The crystals of a specimen: one or several grains each. Where a specimen has none, each grain is a crystal.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack {

std::size_t crystal_of(const Specimen& specimen, std::size_t grain);
std::size_t n_crystals(const Specimen& specimen);

/// The two grains of each contact [c].
std::vector<std::array<std::size_t, 2>> grains_of_contacts(const Specimen& specimen);

/// Whether a contact is within a crystal.
bool is_within_crystal(const Specimen& specimen, std::size_t contact);

/// "452 grains" or, of polygons that break, "300 crystals of 2168 grains".
std::string grains_label(const Specimen& specimen);

}  // namespace graincrack
