// Intact points, most of all points in most steps: what a law gives for them without a branch in the code, for vector units.
#pragma once

#include "solver/law/constants.hpp"

namespace graincrack {

/// An intact point before and after a motion.
struct IntactPoint {
    double old_opening, old_sliding;  ///< m
    double opening, sliding;          ///< m
    double cohesion_left;             ///< β before; 1 if the law has no damage before the peak
};
/// What `update_contact` gives for it, where `holds`.
struct IntactResponse {
    double normal, shear;  ///< Pa
    double holds;          ///< 1 if the point stays intact and nothing but this happens to it, else 0: it needs `update_contact`
    double cohesion_left = 1;
    double fracture = 0;  ///< J/m²
};

namespace contact_law {

/// 1 if the point stays open or stays closed, else 0.
inline double stays_on_its_side(const IntactPoint& p) {
    return (p.opening >= 0) == (p.old_opening >= 0) ? 1.0 : 0.0;
}

}  // namespace contact_law
}  // namespace graincrack
