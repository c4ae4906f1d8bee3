// Friction of a failed, closed contact: Kazerani & Zhao (2014), Eqs 10, 12, as signed increments.
//
// τ = ks (δs − slip) within ±limit, σres = −kt δn tan φc in the paper. The slip is the state; as printed, Eq 12 would feed energy
// on a reversal.
//
// Energy. A step of a scheme with central differences does the work ½ (τ0 + τ1) Δδs, of which ½ (τ0 + τ1)(Δδs − Δslip) is stored:
// friction is ½ (τ0 + τ1) Δslip, exactly. That is negative in one case: the point turns from slip in one direction to slip in the
// other within a step while its limit falls, τ0 > 0, τ1 = −limit, τ0 > limit, Δslip < 0. No admissible traction τ1 would help: as
// τ1 ≥ −limit > −τ0 the sum stays positive, and Δslip ≥ 0 would need τ1 ≤ τ0 + ks Δδs < −limit. Both claims cannot hold in such a
// step, so the first gives way: nothing is booked, and the scheme's error, at most ½ τ0 |Δδs| per area, second order in the step,
// stays in the residual of the ledger where it can be seen.
#pragma once

#include <algorithm>

#include "solver/law/constants.hpp"

namespace graincrack::contact_law {

/// Largest frictional traction at a closed motion, Pa.
inline double friction_limit(const ContactLaw& law, const ContactMotion& m) { return -law.kt * m.opening * law.tan_phi; }

/// Moves a frictional contact to a motion where it bears `limit`: sets the shear traction and the slip, books friction.
inline void slide(const ContactLaw& law, const ContactMotion& to, double limit, ContactResponse& r) {
    const double old_shear = law.ks * (r.history.motion.sliding - r.history.slip);
    const double trial = law.ks * (to.sliding - r.history.slip);
    r.traction.shear = std::clamp(trial, -limit, limit);
    if (trial != r.traction.shear) {
        const double slip = to.sliding - r.traction.shear / law.ks;
        r.dissipation.friction += std::max(0.0, 0.5 * (old_shear + r.traction.shear) * (slip - r.history.slip));
        r.history.slip = slip;
    }
}

}  // namespace graincrack::contact_law
