// The rock of Kazerani & Zhao (2014): what that paper found for it stands beside results for it, and beside no other rock's.
#pragma once

#include <string_view>

namespace graincrack {

/// Augig granite, also with words behind its name. \param material its name
inline bool is_rock_of_paper(std::string_view material) { return material.starts_with("Augig granite"); }

/// Means of the paper's model at its calibrated point (Table 8), in the units of the paper.
struct PaperModel {
    double young_modulus = 25.2;          ///< GPa
    double poisson_ratio = 0.24;          ///<
    double tensile_strength = 8.7;        ///< MPa
    double compressive_strength = 125.4;  ///< MPa
    double cohesion = 20.9;               ///< MPa
    double friction_angle = 53.5;         ///< °
};

}  // namespace graincrack
