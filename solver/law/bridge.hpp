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

#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

/// A bridge after a motion.
struct Bridge {
    double normal, shear;  ///< Pa
    double integrity;      ///< b
    double fracture;       ///< dissipated, J/m²; negative where β gives to b
    double remaining;      ///< share of tc that it can bear
};

/// Moves the bridge of a point past its peak on the side of δn = 0 that it is on.
/// \param p its motion, with β before it \param integrity β after it \param bridge b before it
GRAINCRACK_INLINE Bridge advance_bridge(const ContactLaw& law, const IntactPoint& p, double integrity, double bridge,
                                        double slip) {
    constexpr double e = std::numbers::e;
    constexpr double nothing = 1e-30;  // of the square of a load
    const bool closed = p.opening < 0;
    const double origin = bridge > 0 && !closed ? slip : 0.0;
    const double opened = std::max(p.opening, 0.0);
    const double slid = p.sliding - origin;
    const double x = opened * law.inv_dct;
    const double y = slid * law.inv_dso;
    const double load = std::sqrt(std::max(x * x + y * y, nothing));
    const double form = law.kt * opened * opened + law.ks * slid * slid;
    const double line = law.bridge - law.bridge_decay * form / load;
    const double given = closed || origin != 0 ? 0.0 : p.integrity - integrity;
    const double left = std::max(0.0, std::min(bridge + given, line / (e * load) - integrity));
    const double old_opened = std::max(p.old_opening, 0.0);
    const double old_slid = p.old_sliding - origin;
    const double old_form = law.kt * old_opened * old_opened + law.ks * old_slid * old_slid;
    // 1 − D of its line at the integrity, in the direction of an open motion, or of pure opening
    const double stiffness = closed ? law.kt * law.dct * law.dct : form / (load * load);
    const double scaled = e * (integrity + left);
    return {closed ? 0.0 : left * law.kt * opened, closed ? 0.0 : left * law.ks * slid, left,
            closed ? 0.0 : 0.25 * (old_form + form) * (bridge - left),
            left > 0 ? law.bridge * scaled / (law.bridge_decay * stiffness + scaled) : 0.0};
}
/// The slip of a point with the bridge `bridge` before its motion: a bridge begins unstrained at no sliding.
GRAINCRACK_INLINE double slip_of_bridge(double opening, double bridge, double slip) {
    return opening >= 0 && bridge == 0 ? 0.0 : slip;
}
/// What the marks of `damage_levels` see: the brittle part down to one half, whatever a bridge bears, and all below.
GRAINCRACK_INLINE double remaining_with_bridge(double brittle, double bridge) {
    constexpr double below_half = damage_levels[1] * (1 - std::numeric_limits<double>::epsilon());
    return std::max(brittle, std::min(bridge, below_half));
}
/// Adds the bridge to the softening response of a point.
GRAINCRACK_INLINE void add_bridge(const ContactLaw& law, const SofteningPoint& p, SofteningResponse& r) {
    const IntactPoint motion{p.old_opening, p.old_sliding, p.opening, p.sliding, p.integrity};
    const Bridge bridge = advance_bridge(law, motion, r.integrity, p.bridge, p.slip);
    r.normal += bridge.normal;
    r.shear += bridge.shear;
    r.slip = slip_of_bridge(p.opening, p.bridge, r.slip);
    r.fracture += bridge.fracture;
    r.holds = r.integrity + bridge.integrity > 0 ? stays_on_its_side(motion) : 0.0;
    r.remaining_cohesion = remaining_with_bridge(r.remaining_cohesion, bridge.remaining);
    r.bridge = bridge.integrity;
}
/// ½ b (kt δn² + ks (δs − slip)²) while open.
inline double bridge_energy(const ContactLaw& law, const ContactHistory& h) {
    const double opened = h.motion.opening;
    const double slid = h.motion.sliding - h.slip;
    return opened >= 0 && h.bridge > 0 ? 0.5 * h.bridge * (law.kt * opened * opened + law.ks * slid * slid) : 0.0;
}
/// A point closes: friction starts from zero, and the shear of the bridge is lost.
inline void close_bridge(const ContactLaw& law, ContactResponse& r) {
    r.dissipation.fracture += bridge_energy(law, r.history);
    r.history.slip = r.history.motion.sliding;
}

}  // namespace graincrack::contact_law
