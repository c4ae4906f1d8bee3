// The reading `consistent`: the paper's curves with one damage variable, an energy, and a dissipation that is never negative.
//
// Of the cohesion of a point the share β is left (1 at first), and a share a carries friction (0 at first):
//
//   ψ = ½ β (kt⟨δn⟩² + ks δs²) + ½ kt⟨−δn⟩² + ½ a ks (δs − slip)²          the last term while closed only
//   open     (σn, τ) = β (kt δn, ks δs)
//   closed   σn = kt δn, τ = β ks δs + a ks (δs − slip), the second term within ±a σres
//
// β never grows; it follows the load λ of the branch the point is on:
//
//   open     λ = √((δn/δct)² + (δs/δso)²):   β ≤ e^(−λ) up to λ = 1, then β ≤ (1 − D)/(e λ), D = (λ − 1)/(λu − 1)
//   closed   λ = |δs|/δcs:                    β ≤ e^(−λ) up to λ = 1, then β = 0: cohesion is lost at once
//
// Pure opening gives Eq 7's curve with area Gf, sliding under compression Eq 10's. What the paper calls non-linear elastic is
// damage here: un- and reloading go along the secant before the peak too. δso = e to/ks: an open contact has the strength to in
// shear, a parameter; with to = tc √κ, the default, λ² is the energy ½ (kt δn² + ks δs²) over that of δct, so that damage follows
// the force that is conjugate to it. λu gives every direction of opening the energy Gf. A point that failed closed carries
// friction on all of its area, from the traction it had (Eq 12); one that failed open on the share D it has lost, from zero when
// it closes (Alfano & Sacco 2006, Int J Numer Meth Engng 68: friction on the damaged part). Shares are merged by their mean
// slip; energy is convex in slip, so what is lost thereby is never negative. Over δn = 0 only β can change, and only fall: that
// costs energy and never makes any, so there is no mismatch. Coupling is full by nature.
#pragma once

#include <numbers>

#include "solver/law/exponential.hpp"
#include "solver/law/friction.hpp"
#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

/// D of the open branch at a load λ ≥ 1 in a direction in which q = kt δn² + ks δs² is `stiffness` λ².
inline double consistent_damage(const ContactLaw& law, double load, double stiffness) {
    constexpr double e = std::numbers::e;
    // Work along a straight path: `stiffness` · [(1 − 2/e) + (λu − 1)/(2 e)] = Gf.
    const double range = 2 * e * (law.gf / stiffness - (1 - 2 / e));
    return range > load - 1 ? (load - 1) / range : 1.0;
}

struct Consistent {
    static constexpr LawDescription description{.variant = LawVariant::consistent,
                                                .name = "consistent",
                                                .meaning = "one damage variable, an energy, no mismatch",
                                                .potential = true,
                                                .fracture_energy = true,
                                                .open_shear_strength = true};
    static constexpr bool damages_intact = true;
    /// In pure opening. A direction in which the way to the peak takes more than Gf has no softening and takes that.
    static FractureEnergies min_energies(const ContactLaw& law) { return {law.tc * law.dct * (std::numbers::e - 2), 0}; }
    static void complete(ContactLaw& law) {
        law.stiffest_shear = law.ks;
        law.inv_dso = law.ks / (std::numbers::e * law.open_shear_strength);
    }

    static void advance_open(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double x = to.opening * law.inv_dct;
        const double y = to.sliding * law.inv_dso;
        const double load = std::sqrt(x * x + y * y);
        const double q = law.kt * to.opening * to.opening + law.ks * to.sliding * to.sliding;
        double left = 0;
        if (load <= 1) {
            left = exp_of_minus(load);
        } else {
            mark_failed(h, CrackMode::tensile);
            const double lost = consistent_damage(law, load, q / (load * load));
            h.friction_share = std::max(h.friction_share, lost);
            left = (1 - lost) / (std::numbers::e * load);
        }
        const double before = h.integrity;
        h.integrity = std::min(before, left);
        // The motion before is open too, so both values of q are those of ψ; the change of β is booked at their mean.
        const double q_before = law.kt * h.motion.opening * h.motion.opening + law.ks * h.motion.sliding * h.motion.sliding;
        r.dissipation.fracture += 0.25 * (q_before + q) * (before - h.integrity);
        h.separated = h.separated || h.integrity == 0;
        r.traction = {h.integrity * law.kt * to.opening, h.integrity * law.ks * to.sliding};
        h.motion = to;
    }
    static void advance_closed(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const ContactMotion from = h.motion;
        const double limit = friction_limit(law, to);
        const double load = std::abs(to.sliding) * law.inv_dcs;
        ContactResponse friction{{}, h, {}};
        slide(law, to, limit, friction);
        h.slip = friction.history.slip;
        r.dissipation.friction += h.friction_share * friction.dissipation.friction;
        double frictional_shear = friction.traction.shear;
        if (load <= 1) {
            const double before = h.integrity;
            h.integrity = std::min(before, exp_of_minus(load));
            const double q_before = law.ks * from.sliding * from.sliding;
            r.dissipation.fracture += 0.25 * (q_before + law.ks * to.sliding * to.sliding) * (before - h.integrity);
        } else if (h.integrity > 0) {
            // The peak is passed: the cohesive share goes on with friction, from the traction it had.
            const double share = 1 - h.friction_share;
            const double carried = std::clamp(h.integrity * law.ks * to.sliding / share, -limit, limit);
            const double stored =
                h.integrity * law.ks * to.sliding * to.sliding + h.friction_share * frictional_shear * frictional_shear / law.ks;
            h.slip = h.friction_share * h.slip + share * (to.sliding - carried / law.ks);
            frictional_shear = law.ks * (to.sliding - h.slip);
            h.integrity = 0;
            h.friction_share = 1;
            mark_failed(h, CrackMode::shear);
            r.dissipation.fracture += 0.5 * (stored - frictional_shear * frictional_shear / law.ks);
        }
        r.traction = {law.kt * to.opening, h.integrity * law.ks * to.sliding + h.friction_share * frictional_shear};
        h.motion = to;
    }
    /// A contact closes: no normal traction yet, so no friction.
    static void close(const ContactLaw& /*law*/, ContactHistory& h) { h.slip = h.motion.sliding; }
    static double stored_energy(const ContactLaw& law, const ContactHistory& h) {
        const ContactMotion& m = h.motion;
        const double shear = law.ks * m.sliding * m.sliding;
        if (m.opening >= 0) {
            return 0.5 * h.integrity * (law.kt * m.opening * m.opening + shear);
        }
        const double elastic = m.sliding - h.slip;
        return 0.5 * (law.kt * m.opening * m.opening + h.integrity * shear + h.friction_share * law.ks * elastic * elastic);
    }
    static double damage(const ContactLaw& /*law*/, const ContactHistory& h) { return h.friction_share; }
    static bool is_residual(const ContactLaw& /*law*/, const ContactHistory& h) {
        return h.failed() && h.integrity == 0 && h.friction_share == 1;
    }
    /// Damage before the peak, on either branch; the same arithmetic as above.
    static IntactResponse intact(const ContactLaw& law, const IntactPoint& p) {
        const bool open = p.opening >= 0;
        const double opened = std::max(p.opening, 0.0);
        const double old_opened = std::max(p.old_opening, 0.0);
        const double x = opened * law.inv_dct;
        const double y = p.sliding * (open ? law.inv_dso : law.inv_dcs);
        const double load = std::sqrt(x * x + y * y);
        const double left = std::min(p.integrity, exp_of_minus(load));
        const double q = law.kt * opened * opened + law.ks * p.sliding * p.sliding;
        const double old_q = law.kt * old_opened * old_opened + law.ks * p.old_sliding * p.old_sliding;
        return {(open ? left : 1.0) * law.kt * p.opening, left * law.ks * p.sliding, load <= 1 ? stays_on_its_side(p) : 0.0, left,
                0.25 * (old_q + q) * (p.integrity - left)};
    }
};

}  // namespace graincrack::contact_law
