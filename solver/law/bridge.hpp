// Bridges: what still holds a contact point after its brittle opening, interlocked grains and ligaments, as a small stress over a
// long opening (Sato, Hashida & Takahashi 1996; Swanson 1987 on granite). Laws with the integrity β of `cohesive_damage.hpp` have
// them; σb = 0: none.
//
// While open the whole integrity β + b, that of the brittle part and that of the bridge, follows the higher of two softenings:
//
//   e λ (β + b) ≤ max(1 − D, ρ (1 − λ/λb)),   ρ = σb/tc,   λb = 2 Gb λ² e tc/(σb q)
//
// In pure opening the bridge is σb (1 − δn/δb), δb = 2 Gb/σb; λb gives every direction of opening the energy Gb. β is that of a
// law without bridges, so b grows by what β loses until it is on its line, and only falls from then on.
//
// While closed the bridge carries nothing: a second cohesion there would hide the fall of strength. It is torn by the sliding
// that tears it while open. A point that opens again finds the bridge it had, unstrained: its shear starts from the slip at which
// friction has left the point. Such a bridge does not grow: what β loses then is lost.
//
// Energy: ½ b (kt δn² + ks (δs − slip)²) while open, 0 while closed, so that the shear of a bridge whose point closes is
// dissipated. β gives to b only where both have the same energy, slip = 0.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "solver/law/cohesive_damage.hpp"

namespace graincrack::contact_law {

/// A bridge after a motion.
struct Bridge {
    double normal, shear;  ///< Pa
    double integrity;      ///< b
    double fracture;       ///< dissipated, J/m²; negative where β gives to b
    double remaining;      ///< share of tc that it can bear
};

/// λ of an open motion. \param opened ⟨δn⟩ \param slid δs from where the shear of the bridge starts
GRAINCRACK_INLINE double load_of_bridge(const ContactLaw& law, double opened, double slid) {
    constexpr double nothing = 1e-30;  // of the square of a load
    const double x = opened * law.inv_dct;
    const double y = slid * law.inv_dso;
    return std::sqrt(std::max(x * x + y * y, nothing));
}
/// ρ (1 − λ/λb) in the direction of a motion with the load λ and the form q.
GRAINCRACK_INLINE double line_of_bridge(const ContactLaw& law, double load, double form) {
    return law.bridge - law.bridge_decay * form / load;
}
/// The same where e λ (β + b) = `scaled` is on the line, in a direction in which q = `stiffness` λ².
GRAINCRACK_INLINE double line_at_integrity(const ContactLaw& law, double scaled, double stiffness) {
    return law.bridge * scaled / (law.bridge_decay * stiffness + scaled);
}

/// Moves the bridge of a point past its peak on the side of δn = 0 that it is on.
/// \param p its motion, with β before it \param integrity β after it \param bridge b before it
GRAINCRACK_INLINE Bridge advance_bridge(const ContactLaw& law, const MovedPoint& p, double integrity, double bridge,
                                        double slip) {
    constexpr double e = std::numbers::e;
    const bool closed = p.opening < 0;
    const double origin = bridge > 0 && !closed ? slip : 0.0;
    const double opened = std::max(p.opening, 0.0);
    const double slid = p.sliding - origin;
    const double load = load_of_bridge(law, opened, slid);
    const double form = cohesive_form(law, p.opening, slid);
    const double given = closed || origin != 0 ? 0.0 : p.integrity - integrity;
    const double left = std::max(0.0, std::min(bridge + given, line_of_bridge(law, load, form) / (e * load) - integrity));
    const double mean_form = 0.5 * (cohesive_form(law, p.old_opening, p.old_sliding - origin) + form);
    // 1 − D of its line in the direction of an open motion, or of pure opening
    const double stiffness = closed ? law.kt * law.dct * law.dct : form / (load * load);
    const double remaining = left > 0 ? line_at_integrity(law, e * (integrity + left), stiffness) : 0.0;
    return {closed ? 0.0 : left * law.kt * opened, closed ? 0.0 : left * law.ks * slid, left,
            closed ? 0.0 : 0.5 * mean_form * (bridge - left), remaining};
}
/// The slip of a point with the bridge `bridge` before its motion: a bridge begins unstrained at no sliding.
GRAINCRACK_INLINE double slip_of_bridge(double opening, double bridge, double slip) {
    return opening >= 0 && bridge == 0 ? 0.0 : slip;
}
/// Remaining cohesion for `damage_levels`: the brittle part alone above one half, brittle part and bridge below.
GRAINCRACK_INLINE double remaining_with_bridge(double brittle, double bridge) {
    constexpr double below_half = damage_levels[1] * (1 - std::numeric_limits<double>::epsilon());
    return std::max(brittle, std::min(bridge, below_half));
}
/// Adds the bridge to the softening response of a point.
GRAINCRACK_INLINE void add_bridge(const ContactLaw& law, const MovedPoint& p, SofteningResponse& r) {
    const Bridge bridge = advance_bridge(law, p, r.integrity, p.bridge, p.slip);
    r.normal += bridge.normal;
    r.shear += bridge.shear;
    r.slip = slip_of_bridge(p.opening, p.bridge, r.slip);
    r.fracture += bridge.fracture;
    r.holds = r.integrity + bridge.integrity > 0 ? stays_on_its_side(p) : 0.0;
    r.remaining_cohesion = remaining_with_bridge(r.remaining_cohesion, bridge.remaining);
    r.bridge = bridge.integrity;
}
/// ½ b (kt δn² + ks (δs − slip)²) while open.
inline double bridge_energy(const ContactLaw& law, const ContactHistory& h) {
    const bool bears = h.motion.opening >= 0 && h.bridge > 0;
    return bears ? 0.5 * h.bridge * cohesive_form(law, h.motion.opening, h.motion.sliding - h.slip) : 0.0;
}
/// A point closes: friction starts from zero, and the shear of the bridge is lost.
inline void close_bridge(const ContactLaw& law, ContactResponse& r) {
    r.dissipation.fracture += bridge_energy(law, r.history);
    r.history.slip = r.history.motion.sliding;
}

}  // namespace graincrack::contact_law
