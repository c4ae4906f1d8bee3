// Identifies the rock of Kazerani & Zhao (2014), the only one whose results are compared with those of the paper.
#pragma once

#include <string_view>

namespace graincrack {

/// True for Augig granite, also with further words in its name. \param material its name
inline bool is_rock_of_paper(std::string_view material) { return material.starts_with("Augig granite"); }

}  // namespace graincrack
