// `consistent` (share/doc/laws.md): the curves of Kazerani & Zhao (2014) with the integrity β of `cohesive_damage.hpp`, a
// fraction a of the area that carries friction, and an energy:
//
//   ψ = ½ β (kt⟨δn⟩² + ks δs²) + ½ kt⟨−δn⟩² + ½ a ks (δs − slip)²          the last term while closed only
//   open     (σn, τ) = β (kt δn, ks δs)
//   closed   σn = kt δn, τ = β ks δs + a ks (δs − slip), the second term within ±a σres
//
// While open the softening has the area Gf; past the peak of the closed branch β = 0 at once, and friction has all of the area,
// from the traction that the point had (Eq 12). A point that failed open carries friction on the fraction D of the area (Alfano &
// Sacco 2006, Int J Numer Meth Engng 68), from zero. When it fails while closed, both fractions continue with their mean slip;
// the energy is convex in the slip, so the loss is never negative. Bridges are those of `bridge.hpp`.
#pragma once

#include "solver/law/bridge.hpp"

namespace graincrack::contact_law {

struct Consistent {
    static constexpr LawDescription description{
        .variant = LawVariant::consistent,
        .name = "consistent",
        .meaning = "one damage variable, an energy everywhere",
        .potential = true,
        .parameters = {&ContactParameters::fracture_energy, &ContactParameters::open_shear_strength,
                       &ContactParameters::bridging_strength, &ContactParameters::bridging_energy}};
    static constexpr bool damages_intact = true;
    static FractureEnergies min_energies(const ContactLaw& law) { return {min_opening_energy(law), 0}; }
    static void complete(ContactLaw& law) {
        law.stiffest_shear = law.ks;
        law.inv_dso = inverse_open_sliding(law);
    }

    /// Up to the peak cohesion responds as that of an intact point; beyond it, it softens (open) or is lost (closed). Friction of
    /// a closed point responds as that of a residual point.
    static void advance(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const bool open = to.opening >= 0;
        const double load = cohesive_load(law, to.opening, to.sliding);
        const MovedPoint motion = moved_point(h, to);
        double frictional_shear = 0;
        if (!open) {
            const ResidualResponse friction = residual_response(law, moved_point(h, to));
            frictional_shear = friction.shear;
            h.slip = friction.slip;
            r.dissipation.friction += h.friction_fraction * friction.friction;
        }
        if (load <= 1) {
            const IntactResponse cohesion = intact(law, motion);
            h.integrity = cohesion.integrity;
            r.dissipation.fracture += cohesion.fracture;
        } else if (open) {
            soften(law, to, load, r);
        } else if (h.integrity > 0) {
            frictional_shear = lose_cohesion(law, to, frictional_shear, r);
        }
        const double shear = h.integrity * law.ks * to.sliding;
        r.traction = open ? ContactTraction{h.integrity * law.kt * to.opening, shear}
                          : ContactTraction{law.kt * to.opening, shear + h.friction_fraction * frictional_shear};
        if (law.bridge > 0 && h.failed()) bear_bridge(law, motion, r);
        h.separated = h.separated || (open && h.integrity == 0 && h.bridge == 0);
        h.motion = to;
    }
    static void close(const ContactLaw& law, ContactResponse& r) { close_bridge(law, r); }
    static double stored_energy(const ContactLaw& law, const ContactHistory& h) {
        return damaged_energy(law, h) + bridge_energy(law, h);
    }
    static double damage(const ContactLaw& /*law*/, const ContactHistory& h) { return h.friction_fraction; }
    static bool is_residual(const ContactLaw& /*law*/, const ContactHistory& h) {
        return h.failed() && h.integrity == 0 && h.bridge == 0 && h.friction_fraction == 1;
    }
    static IntactResponse intact(const ContactLaw& law, const MovedPoint& p) { return damage_before_peak(law, p); }

private:
    /// Past the peak of the open branch: β follows the softening curve, and the lost fraction of the area will carry friction.
    static void soften(const ContactLaw& law, const ContactMotion& to, double load, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double lost = open_damage(law, load, cohesive_form(law, to.opening, to.sliding) / (load * load));
        const double integrity = std::min(h.integrity, (1 - lost) / (std::numbers::e * load));
        mark_failed(h, CrackMode::tensile);
        h.friction_fraction = std::max(h.friction_fraction, lost);
        r.dissipation.fracture += energy_of_fall(law, moved_point(h, to), h.integrity - integrity);
        h.integrity = integrity;
    }
    /// Adds what the bridge bears to the traction.
    static void bear_bridge(const ContactLaw& law, const MovedPoint& motion, ContactResponse& r) {
        ContactHistory& h = r.history;
        const Bridge bridge = advance_bridge(law, motion, h.integrity, h.bridge, h.slip);
        h.slip = slip_of_bridge(motion.opening, h.bridge, h.slip);
        h.bridge = bridge.integrity;
        r.traction.normal += bridge.normal;
        r.traction.shear += bridge.shear;
        r.dissipation.fracture += bridge.fracture;
    }
    /// Past the peak of the closed branch: the cohesive fraction continues with friction, from the traction it had.
    /// \return the traction of friction on the whole area, Pa
    static double lose_cohesion(const ContactLaw& law, const ContactMotion& to, double old_friction, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double limit = friction_limit(law, to);
        const double fraction = 1 - h.friction_fraction;
        const double carried = std::clamp(h.integrity * law.ks * to.sliding / fraction, -limit, limit);
        const double stored =
            h.integrity * law.ks * to.sliding * to.sliding + h.friction_fraction * old_friction * old_friction / law.ks;
        h.slip = h.friction_fraction * h.slip + fraction * (to.sliding - carried / law.ks);
        h.integrity = 0;
        h.friction_fraction = 1;
        mark_failed(h, CrackMode::shear);
        const double friction = law.ks * (to.sliding - h.slip);
        r.dissipation.fracture += 0.5 * (stored - friction * friction / law.ks);
        return friction;
    }
};

}  // namespace graincrack::contact_law
