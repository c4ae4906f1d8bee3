// The rock of Kazerani & Zhao (2014): what that paper found for it stands beside results for it, and beside no other rock's.
#pragma once

#include <string_view>

namespace graincrack {

/// Augig granite, also with words behind its name. \param material its name
inline bool is_rock_of_paper(std::string_view material) { return material.starts_with("Augig granite"); }

}  // namespace graincrack
