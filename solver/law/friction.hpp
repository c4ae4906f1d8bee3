// Friction of a failed, closed contact: Kazerani & Zhao (2014), Eqs 10, 12, as signed increments.
//
// τ = ks (δs − slip) within ±σres, σres = −kt δn tan φc. The slip is the state; as printed, Eq 12 would feed energy on a
// reversal.
#pragma once

#include <algorithm>

#include "solver/law/constants.hpp"

namespace graincrack::contact_law {

/// Largest frictional traction at a closed motion, Pa.
inline double friction_limit(const ContactLaw& law, const ContactMotion& m) { return -law.kt * m.opening * law.tan_phi; }

/// Moves a frictional contact to a closed motion: sets the shear traction and the slip, books friction.
inline void slide(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    const double limit = friction_limit(law, to);
    const double old_shear = law.ks * (r.history.motion.sliding - r.history.slip);
    const double trial = law.ks * (to.sliding - r.history.slip);
    r.traction.shear = std::clamp(trial, -limit, limit);
    const double slip = to.sliding - r.traction.shear / law.ks;
    if (trial != r.traction.shear) {
        r.dissipation.friction += 0.5 * (old_shear + r.traction.shear) * (slip - r.history.slip);
        r.history.slip = slip;
    }
}

}  // namespace graincrack::contact_law
