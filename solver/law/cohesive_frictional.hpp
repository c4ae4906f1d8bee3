// `cohesive-frictional` (share/doc/laws.md): the law `consistent` whose closed contacts lose their cohesion over a fracture
// energy G_II, with friction mobilised beside it, so that the strength depends on pressure before a contact has failed.
//
//   open     (σn, τ) = β (kt δn, ks δs)
//   closed   σn = kt δn, τ = β ks δs + a ks (δs − slip), the second term within ±|σn| tan φ
//
// β is the integrity of `cohesive_damage.hpp`; while closed it falls linearly from cc at δcs to zero at δcs (1 + s), s = 2
// [G_II/(cc δcs) − (e − 2)]. a is 0 until the point fails and 1 from then on. tan φ falls from tan φc to tan φr in proportion to
// 1 − D of the closed branch (Hajiabdolmajid, Kaiser & Martin 2002, Int J Rock Mech Min Sci 39). Where G_II is no more than the
// energy to the peak, cc δcs (e − 2), cohesion is lost at once and friction starts from the traction the point had (Eq 12).
//
// Bridges are those of `bridge.hpp`, the energy is that of `consistent`.
#pragma once

#include "solver/law/bridge.hpp"

namespace graincrack::contact_law {

struct CohesiveFrictional {
    static constexpr LawDescription description{
        .variant = LawVariant::cohesive_frictional,
        .name = "cohesive-frictional",
        .meaning = "friction beside a cohesion that softens over G_II",
        .potential = true,
        .friction_beside_cohesion = true,
        .parameters = {&ContactParameters::fracture_energy, &ContactParameters::mode_ii_fracture_energy,
                       &ContactParameters::open_shear_strength, &ContactParameters::residual_friction_angle,
                       &ContactParameters::bridging_strength, &ContactParameters::bridging_energy,
                       &ContactParameters::wear_slip}};
    static constexpr bool damages_intact = true;
    static constexpr bool remembers_largest = false;
    static FractureEnergies min_energies(const ContactLaw& law) { return {min_opening_energy(law), 0}; }
    static void complete(ContactLaw& law) {
        law.stiffest_shear = 2 * law.ks;  // cohesion and friction side by side
        law.inv_dso = inverse_open_sliding(law);
        law.s_range = std::max(0.0, softening_range(law.g2, law.ks * law.dcs * law.dcs));
        law.softens_in_shear = law.s_range > 0;
    }

    static void advance(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        if (!h.failed()) {
            if (advance_intact<CohesiveFrictional>(law, to, r)) return;
            fail(law, to, r);
        }
        if (is_residual(law, h)) {
            advance_residual(law, to, r);
            return;
        }
        advance_softening<CohesiveFrictional>(law, to, r);
        h.separated = h.separated || (to.opening >= 0 && is_residual(law, h));
    }
    static void close(const ContactLaw& law, ContactResponse& r) { close_bridge(law, r); }
    static double stored_energy(const ContactLaw& law, const ContactHistory& h) {
        return damaged_energy(law, h) + bridge_energy(law, h);
    }
    static double damage(const ContactLaw& law, const ContactHistory& h) {
        return h.failed() ? 1 - remaining_cohesion(law, h.integrity) : 0;
    }
    /// On the branch and in the direction of the point's motion.
    static double remaining_cohesion(const ContactLaw& law, const ContactHistory& h) {
        return remaining_cohesion(law, h.motion.opening, h.motion.sliding, h.integrity);
    }
    static bool is_residual(const ContactLaw& /*law*/, const ContactHistory& h) {
        return h.failed() && h.integrity == 0 && h.bridge == 0;
    }
    static IntactResponse intact(const ContactLaw& law, const MovedPoint& p) { return damage_before_peak(law, p); }
    /// Cohesion past the peak, and friction beside it while closed.
    GRAINCRACK_INLINE static SofteningResponse softening(const ContactLaw& law, const MovedPoint& p) {
        const bool closed = p.opening < 0;
        const double integrity = std::min(p.integrity, integrity_at(law, p.opening, p.sliding));
        const double limit = -law.kt * std::min(p.opening, 0.0) * tan_friction(law, integrity);
        const FrictionReturn friction = friction_return(law.ks, p.old_sliding, p.sliding, p.slip, limit);
        return {(closed ? 1.0 : integrity) * law.kt * p.opening,
                integrity * law.ks * p.sliding + (closed ? friction.shear : 0.0),
                integrity,
                closed ? friction.slip : p.slip,
                energy_of_fall(law, p, p.integrity - integrity),
                closed ? friction.dissipated : 0.0,
                integrity > 0 ? stays_on_its_side(p) : 0.0,
                remaining_cohesion(law, p.opening, p.sliding, integrity)};
    }
    /// The same with a bridge beside it while open.
    GRAINCRACK_INLINE static SofteningResponse bridged_softening(const ContactLaw& law, const MovedPoint& p) {
        SofteningResponse r = softening(law, p);
        add_bridge(law, p, r);
        return r;
    }

private:
    /// The largest integrity that a motion leaves a failed point. Up to the peak load it is 1, more than any of them has.
    GRAINCRACK_INLINE static double integrity_at(const ContactLaw& law, double opening, double sliding) {
        const double load = cohesive_load(law, opening, sliding);
        const double open_range = softening_range(law.gf * load * load, cohesive_form(law, opening, sliding));
        const double lost = softening_damage(load, opening >= 0 ? open_range : law.s_range);
        return load <= 1 ? 1 : (1 - lost) / (std::numbers::e * load);
    }
    /// 1 − D at an integrity: β = (1 − D)/(e λ) with D = (λ − 1)/`range` solved for 1 − D; 1 before the peak.
    GRAINCRACK_INLINE static double remaining_cohesion(double integrity, double range) {
        const double scaled = std::numbers::e * integrity;
        return std::min(1.0, scaled * (1 + range) / (1 + range * scaled));
    }
    /// 1 − D of the closed branch.
    GRAINCRACK_INLINE static double remaining_cohesion(const ContactLaw& law, double integrity) {
        return remaining_cohesion(integrity, law.s_range);
    }
    /// 1 − D of the branch and direction of a motion; at no displacement, of pure opening.
    GRAINCRACK_INLINE static double remaining_cohesion(const ContactLaw& law, double opening, double sliding, double integrity) {
        constexpr double nothing = 1e-30;  // of the square of a load
        const double load = cohesive_load(law, opening, sliding);
        const double form = std::max(cohesive_form(law, opening, sliding), nothing * law.kt * law.dct * law.dct);
        const double open_range = std::max(0.0, softening_range(law.gf * std::max(load * load, nothing), form));
        return remaining_cohesion(integrity, opening >= 0 ? open_range : law.s_range);
    }
    GRAINCRACK_INLINE static double tan_friction(const ContactLaw& law, double integrity) {
        return law.residual_tan_phi + (law.tan_phi - law.residual_tan_phi) * remaining_cohesion(law, integrity);
    }
    /// The point passes its peak. Where no softening is left while closed, friction takes over the traction it had.
    static void fail(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const bool closed = to.opening < 0;
        mark_failed(h, closed ? CrackMode::shear : CrackMode::tensile);
        h.friction_fraction = 1;
        if (!closed) return;
        h.slip = to.sliding;
        if (integrity_at(law, to.opening, to.sliding) == 0) {
            const double limit = residual_limit(law, -law.kt * to.opening);
            const double cohesive = h.integrity * law.ks * to.sliding;
            const double carried = std::clamp(cohesive, -limit, limit);
            r.dissipation.fracture += 0.5 * (cohesive * to.sliding - carried * carried / law.ks);
            h.slip = to.sliding - carried / law.ks;
            h.integrity = 0;
        }
    }
};

}  // namespace graincrack::contact_law
