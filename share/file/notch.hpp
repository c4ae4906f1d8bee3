// The notch of a specimen, as it came out.
#pragma once

#include <array>
#include <optional>

#include "share/file/specimen.hpp"

namespace graincrack {

/// Ends along x, m, of the contacts that are broken from the start (kind `pre_existing_crack`); empty without any.
std::optional<std::array<double, 2>> notch_ends(const Specimen& specimen);

}  // namespace graincrack
