// Bridges: interlocked grains and ligaments hold a contact point after its brittle opening with a small stress over a long
// opening (Sato, Hashida & Takahashi 1996; Swanson 1987 on granite). Laws with the integrity β of `cohesive_damage.hpp` have
// bridges; a bridging strength σb of 0 removes them.
//
// While a point is open, the sum β + b of the integrities of brittle part and bridge follows the higher of two softening curves:
//
//   e λ (β + b) ≤ max(1 − D, ρ (1 − λ/λb)),   ρ = σb/tc,   λb = 2 Gb λ² e tc/(σb q)
//
// In pure opening the stress of the bridge is σb (1 − δn/δb) with δb = 2 Gb/σb; λb gives every direction of opening the energy
// Gb. β is that of a law without bridges. So b grows by the loss of β until β + b reaches the line of the bridge, and falls from
// then on.
//
// While a point is closed its bridge carries nothing, as a second cohesion would hide the fall of strength. The same sliding
// tears it as while open. When the point opens again, the bridge is unstrained: its shear starts from the slip at which friction
// has left the point. Such a bridge does not grow; a further loss of β is lost.
//
// The stored energy is ½ b (kt δn² + ks (δs − slip)²) while open and 0 while closed, so that the shear of a bridge is dissipated
// when its point closes. β passes to b only while both have the same energy (slip = 0).
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "solver/law/cohesive_damage.hpp"

namespace graincrack::contact_law {

/// The response of a bridge to a motion.
struct Bridge {
    double normal, shear;  ///< Pa
    double integrity;      ///< b
    double fracture;       ///< dissipated energy, J/m²; negative where β passes to b
    double remaining;      ///< fraction of tc that the bridge can bear
};

/// λ of an open motion. \param opened ⟨δn⟩, m \param slid δs from the origin of the bridge's shear, m
GRAINCRACK_INLINE double load_of_bridge(const ContactLaw& law, double opened, double slid) {
    constexpr double nothing = 1e-30;  // lower bound of λ², against division by zero
    const double x = opened * law.inv_dct;
    const double y = slid * law.inv_dso;
    return std::sqrt(std::max(x * x + y * y, nothing));
}
/// ρ (1 − λ/λb) in the direction of a motion with the load λ and the form q.
GRAINCRACK_INLINE double line_of_bridge(const ContactLaw& law, double load, double form) {
    return law.bridge - law.bridge_decay * form / load;
}
/// The same at the point of the line with e λ (β + b) = `scaled`, in a direction in which q = `stiffness` λ².
GRAINCRACK_INLINE double line_at_integrity(const ContactLaw& law, double scaled, double stiffness) {
    return law.bridge * scaled / (law.bridge_decay * stiffness + scaled);
}

/// Advances the bridge of a point past its peak; the motion stays on one side of δn = 0.
/// \param p the motion, with β before it \param integrity β after it \param bridge b before it \param slip before it, m
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
    // 1 − D on its line, in the direction of the motion or, while closed, of pure opening
    const double stiffness = closed ? law.kt * law.dct * law.dct : form / (load * load);
    const double remaining = left > 0 ? line_at_integrity(law, e * (integrity + left), stiffness) : 0.0;
    return {closed ? 0.0 : left * law.kt * opened, closed ? 0.0 : left * law.ks * slid, left,
            closed ? 0.0 : 0.5 * mean_form * (bridge - left), remaining};
}
/// The slip of a point with the bridge `bridge` before its motion: the shear of a new bridge starts from no sliding.
GRAINCRACK_INLINE double slip_of_bridge(double opening, double bridge, double slip) {
    return opening >= 0 && bridge == 0 ? 0.0 : slip;
}
/// Remaining cohesion for `damage_levels`: that of the brittle part above one half, the larger of brittle part and bridge below.
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
/// The stored energy ½ b (kt δn² + ks (δs − slip)²) of a bridge, J/m²; 0 while closed.
inline double bridge_energy(const ContactLaw& law, const ContactHistory& h) {
    const bool bears = h.motion.opening >= 0 && h.bridge > 0;
    return bears ? 0.5 * h.bridge * cohesive_form(law, h.motion.opening, h.motion.sliding - h.slip) : 0.0;
}
/// Closes a point: its friction starts from zero, and the energy of the bridge is dissipated.
inline void close_bridge(const ContactLaw& law, ContactResponse& r) {
    r.dissipation.fracture += bridge_energy(law, r.history);
    r.history.slip = r.history.motion.sliding;
}

}  // namespace graincrack::contact_law
