// Coulomb friction of a contact point: Kazerani & Zhao (2014), Eqs 10, 12, as signed increments.
//
// τ = ks (δs − slip) within ±limit; the limit is −kt δn tan φc in the paper. The slip is the history variable. As printed, Eq 12
// would create energy when the slip reverses.
//
// Energy. Over a step, the central-difference scheme does the work ½ (τ0 + τ1) Δδs on a point; friction dissipates ½ (τ0 + τ1)
// Δslip of it. This is negative where a point turns within a step from slip in one direction to slip in the other while its limit
// falls (τ0 > 0, τ1 = −limit, limit < τ0, Δslip < 0), and no admissible traction avoids it. Then no dissipation is booked. The
// error, at most ½ τ0 |Δδs| and of second order in the step, is visible in the energy balance.
#pragma once

#include <algorithm>

#include "solver/arithmetic/simd.hpp"
#include "solver/law/types.hpp"

namespace graincrack::contact_law {

/// Largest frictional traction of the friction angle φc at a closed motion, Pa.
inline double friction_limit(const ContactLaw& law, const ContactMotion& m) { return -law.kt * m.opening * law.tan_phi; }
/// Largest shear traction of a closed point on which nothing but friction is left: c_r + p tan φ_r, Pa.
/// \param pressure p, Pa
inline double residual_limit(const ContactLaw& law, double pressure) { return law.residual_cc + pressure * law.residual_tan_phi; }

/// The state of a frictional point after a motion.
struct FrictionReturn {
    double shear;       ///< Pa
    double slip;        ///< m
    double dissipated;  ///< J/m²
};
/// Returns the elastic shear traction to within ±`limit` (Pa). Has no branch, so that vector units can work on it.
GRAINCRACK_INLINE FrictionReturn friction_return(double ks, double old_sliding, double sliding, double old_slip, double limit) {
    const double old_shear = ks * (old_sliding - old_slip);
    const double trial = ks * (sliding - old_slip);
    const double shear = std::min(std::max(trial, -limit), limit);
    const double slip = shear != trial ? sliding - shear / ks : old_slip;
    return {shear, slip, std::max(0.0, 0.5 * (old_shear + shear) * (slip - old_slip))};
}

/// Moves a point whose friction is limited by ±`limit` (Pa): sets the shear traction and the slip, books what friction
/// dissipates.
inline void slide(const ContactLaw& law, const ContactMotion& to, double limit, ContactResponse& r) {
    const FrictionReturn friction = friction_return(law.ks, r.history.motion.sliding, to.sliding, r.history.slip, limit);
    r.traction.shear = friction.shear;
    r.history.slip = friction.slip;
    r.dissipation.friction += friction.dissipated;
}

}  // namespace graincrack::contact_law
