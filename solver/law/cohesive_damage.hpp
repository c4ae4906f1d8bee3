// The damage of a cohesion with one variable: what the variants `consistent` and `cohesive-frictional` share.
//
// The cohesion of a point has the integrity β, 1 at first, which never grows. Its energy is ½ β q, q = kt⟨δn⟩² + ks δs². β
// follows the load λ of the branch the point is on:
//
//   open     λ = √((δn/δct)² + (δs/δso)²)      closed   λ = |δs|/δcs
//
//   up to the peak, λ ≤ 1:   β ≤ e^(−λ)
//   past the peak:           β ≤ (1 − D)/(e λ), D = (λ − 1)/(λu − 1): the traction falls linearly
//
// δso = e to/ks, where to is the shear strength of an open contact. With to = tc √κ, the default, λ² is the energy q over that of
// δct, so that damage follows the force conjugate to it. λu of the open branch gives every direction of opening the energy Gf.
#pragma once

#include <cmath>
#include <numbers>

#include "solver/law/exponential.hpp"
#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

/// λ of the branch that a motion is on.
GRAINCRACK_INLINE double cohesive_load(const ContactLaw& law, double opening, double sliding) {
    const double x = std::max(opening, 0.0) * law.inv_dct;
    const double y = sliding * (opening >= 0 ? law.inv_dso : law.inv_dcs);
    return std::sqrt(x * x + y * y);
}
/// q = kt⟨δn⟩² + ks δs².
GRAINCRACK_INLINE double cohesive_form(const ContactLaw& law, double opening, double sliding) {
    const double opened = std::max(opening, 0.0);
    return law.kt * opened * opened + law.ks * sliding * sliding;
}
/// D at a load past the peak, where λu − 1 is `range`.
GRAINCRACK_INLINE double softening_damage(double load, double range) { return range > load - 1 ? (load - 1) / range : 1.0; }
/// λu − 1 of a branch on which the path to the peak and beyond takes the energy `energy` (J/m²) along a straight path in which
/// q = `stiffness` λ²: `stiffness` · [(1 − 2/e) + (λu − 1)/(2 e)] = `energy`. Not above 0: there is no softening.
GRAINCRACK_INLINE double softening_range(double energy, double stiffness) {
    constexpr double e = std::numbers::e;
    return 2 * e * (energy / stiffness - (1 - 2 / e));
}
/// D of the open branch at a load λ ≥ 1 in a direction in which q = `stiffness` λ².
inline double open_damage(const ContactLaw& law, double load, double stiffness) {
    return softening_damage(load, softening_range(law.gf, stiffness));
}
/// Energy that a fall of β takes from a point while it moves, at the mean of q before and after, J/m².
GRAINCRACK_INLINE double energy_of_fall(const ContactLaw& law, const MovedPoint& p, double fall) {
    return 0.25 * (cohesive_form(law, p.old_opening, p.old_sliding) + cohesive_form(law, p.opening, p.sliding)) * fall;
}
/// Damage before the peak, on either branch.
GRAINCRACK_INLINE IntactResponse damage_before_peak(const ContactLaw& law, const MovedPoint& p) {
    const double load = cohesive_load(law, p.opening, p.sliding);
    const double integrity = std::min(p.integrity, exp_of_minus(load));
    return {(p.opening >= 0 ? integrity : 1.0) * law.kt * p.opening, integrity * law.ks * p.sliding,
            load <= 1 ? stays_on_its_side(p) : 0.0, integrity, energy_of_fall(law, p, p.integrity - integrity)};
}
/// ½ β q + ½ kt⟨−δn⟩² + ½ a ks (δs − slip)², the last term while closed only.
inline double damaged_energy(const ContactLaw& law, const ContactHistory& h) {
    const ContactMotion& m = h.motion;
    const double cohesive = h.integrity * cohesive_form(law, m.opening, m.sliding);
    if (m.opening >= 0) return 0.5 * cohesive;
    const double elastic = m.sliding - h.slip;
    return 0.5 * (law.kt * m.opening * m.opening + cohesive + h.friction_fraction * law.ks * elastic * elastic);
}
/// In pure opening, the energy to the peak. A direction whose path to the peak takes more than Gf has no softening and takes
/// that.
inline double min_opening_energy(const ContactLaw& law) { return law.tc * law.dct * (std::numbers::e - 2); }
/// Under compression, the energy to the peak of sliding, J/m².
inline double energy_to_sliding_peak(const ContactLaw& law) { return law.cc * law.dcs * (std::numbers::e - 2); }
/// 1/δso.
inline double inverse_open_sliding(const ContactLaw& law) { return law.ks / (std::numbers::e * law.open_shear_strength); }

}  // namespace graincrack::contact_law
