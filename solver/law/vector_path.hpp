// Intact points, most of all points in most steps, and spent ones, which carry nothing but friction: what a law gives for them
// without a branch in the code, for vector units.
#pragma once

#include <algorithm>

#include "solver/law/constants.hpp"

namespace graincrack {

/// An intact point before and after a motion.
struct IntactPoint {
    double old_opening, old_sliding;  ///< m
    double opening, sliding;          ///< m
    double integrity;                 ///< β before; 1 if the law has no damage before the peak
};
/// What `update_contact` gives for it, where `holds`.
struct IntactResponse {
    double normal, shear;  ///< Pa
    double holds;          ///< 1 if the point stays intact and nothing but this happens to it, else 0: it needs `update_contact`
    double integrity = 1;
    double fracture = 0;  ///< J/m²
};

namespace contact_law {

/// 1 if the point stays open or stays closed, else 0.
inline double stays_on_its_side(const IntactPoint& p) { return (p.opening >= 0) == (p.old_opening >= 0) ? 1.0 : 0.0; }

}  // namespace contact_law

/// A spent point before and after a motion: one of which `is_residual` of its law says that no cohesion is left.
struct ResidualPoint {
    double old_opening, old_sliding;  ///< m
    double opening, sliding;          ///< m
    double slip;                      ///< before, m
};
/// What `update_contact` gives for it, where `holds`. \see solver/law/friction.hpp
struct ResidualResponse {
    double normal, shear;  ///< Pa
    double slip;           ///< m
    double friction;       ///< dissipated, J/m²
    double holds;          ///< 1 if the point stays open or closed, else 0
};
inline ResidualResponse residual_response(const ContactLaw& law, const ResidualPoint& p) {
    const double pressed = std::min(p.opening, 0.0);
    const double limit = -law.kt * pressed * law.tan_phi;
    const double old_shear = law.ks * (p.old_sliding - p.slip);
    const double trial = law.ks * (p.sliding - p.slip);
    const double shear = std::min(std::max(trial, -limit), limit);
    const double slides = p.opening < 0 && shear != trial ? 1.0 : 0.0;
    const double slip = slides != 0 ? p.sliding - shear / law.ks : p.slip;
    const double friction = std::max(0.0, 0.5 * (old_shear + shear) * (slip - p.slip));
    const double holds = (p.opening >= 0) == (p.old_opening >= 0) ? 1.0 : 0.0;
    return {law.kt * pressed, p.opening < 0 ? shear : 0.0, slip, slides * friction, holds};
}

}  // namespace graincrack
