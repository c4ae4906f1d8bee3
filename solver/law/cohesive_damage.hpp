// Damage of the cohesion by one variable, for the variants `consistent` and `cohesive-frictional`.
//
// The cohesion of a point has the integrity β, which is 1 at first and never grows. Its energy is ½ β q with q = kt⟨δn⟩² + ks
// δs². β follows the load λ of the present branch of the point:
//
//   open     λ = √((δn/δct)² + (δs/δso)²)      closed   λ = |δs|/δcs
//
//   up to the peak, λ ≤ 1:   β ≤ e^(−λ)
//   past the peak:           β ≤ (1 − D)/(e λ), D = (λ − 1)/(λu − 1): the traction falls linearly
//
// Here δso = e to/ks, where to is the shear strength of an open contact. With the default to = tc √κ, λ² is q over its value at
// δct, so that damage follows its conjugate force. λu of the open branch gives every direction of opening the energy Gf.
#pragma once

#include <cmath>
#include <numbers>

#include "solver/law/exponential.hpp"
#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

/// The load λ of a motion on its branch.
GRAINCRACK_INLINE double cohesive_load(const ContactLaw& law, double opening, double sliding) {
    const double x = std::max(opening, 0.0) * law.inv_dct;
    const double y = sliding * (opening >= 0 ? law.inv_dso : law.inv_dcs);
    return std::sqrt(x * x + y * y);
}
/// The form q = kt⟨δn⟩² + ks δs², J/m².
GRAINCRACK_INLINE double cohesive_form(const ContactLaw& law, double opening, double sliding) {
    const double opened = std::max(opening, 0.0);
    return law.kt * opened * opened + law.ks * sliding * sliding;
}
/// The damage D at a load past the peak. \param range λu − 1
GRAINCRACK_INLINE double softening_damage(double load, double range) { return range > load - 1 ? (load - 1) / range : 1.0; }
/// Returns λu − 1 of a branch for which a straight path with q = `stiffness` λ² takes the energy `energy` (J/m²) in total:
/// `stiffness` · [(1 − 2/e) + (λu − 1)/(2 e)] = `energy`. A branch does not soften if the result is at most 0.
GRAINCRACK_INLINE double softening_range(double energy, double stiffness) {
    constexpr double e = std::numbers::e;
    return 2 * e * (energy / stiffness - (1 - 2 / e));
}
/// The damage D of the open branch at a load λ ≥ 1, in a direction in which q = `stiffness` λ².
inline double open_damage(const ContactLaw& law, double load, double stiffness) {
    return softening_damage(load, softening_range(law.gf, stiffness));
}
/// Energy that a fall of β takes from a moving point, with the mean of q before and after the motion, J/m².
GRAINCRACK_INLINE double energy_of_fall(const ContactLaw& law, const MovedPoint& p, double fall) {
    return 0.25 * (cohesive_form(law, p.old_opening, p.old_sliding) + cohesive_form(law, p.opening, p.sliding)) * fall;
}
/// The response with damage before the peak, on either branch.
GRAINCRACK_INLINE IntactResponse damage_before_peak(const ContactLaw& law, const MovedPoint& p) {
    const double load = cohesive_load(law, p.opening, p.sliding);
    const double integrity = std::min(p.integrity, exp_of_minus(load));
    return {(p.opening >= 0 ? integrity : 1.0) * law.kt * p.opening, integrity * law.ks * p.sliding,
            load <= 1 ? stays_on_its_side(p) : 0.0, integrity, energy_of_fall(law, p, p.integrity - integrity)};
}
/// The stored energy ½ β q + ½ kt⟨−δn⟩² + ½ a ks (δs − slip)², with the last term while closed only, J/m².
inline double damaged_energy(const ContactLaw& law, const ContactHistory& h) {
    const ContactMotion& m = h.motion;
    const double cohesive = h.integrity * cohesive_form(law, m.opening, m.sliding);
    if (m.opening >= 0) return 0.5 * cohesive;
    const double elastic = m.sliding - h.slip;
    return 0.5 * (law.kt * m.opening * m.opening + cohesive + h.friction_fraction * law.ks * elastic * elastic);
}
/// Energy to the peak in pure opening, J/m². Directions in which the path to the peak takes more than Gf do not soften.
inline double min_opening_energy(const ContactLaw& law) { return law.tc * law.dct * (std::numbers::e - 2); }
/// Energy to the peak of sliding under compression, J/m².
inline double energy_to_sliding_peak(const ContactLaw& law) { return law.cc * law.dcs * (std::numbers::e - 2); }
/// The inverse 1/δso, 1/m.
inline double inverse_open_sliding(const ContactLaw& law) { return law.ks / (std::numbers::e * law.open_shear_strength); }

}  // namespace graincrack::contact_law
