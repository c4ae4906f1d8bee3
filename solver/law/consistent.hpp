// The variant `consistent`: the paper's curves with one damage variable, an energy, and a dissipation that is never negative.
//
// Of the cohesion of a point the share β remains (1 at first), and a share a carries friction (0 at first):
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
// Pure opening gives Eq 7's curve with area Gf, sliding under compression Eq 10's. Where the paper has non-linear elasticity
// before the peak, this law has damage: a point unloads and reloads along the secant there too.
//
// δso = e to/ks, where to is the shear strength of an open contact, a parameter. With to = tc √κ, the default, λ² is the energy
// ½ (kt δn² + ks δs²) over that of δct, so that damage follows the force conjugate to it. λu gives every direction of opening the
// energy Gf. A point that failed closed carries friction on all of its area, starting from the traction it had (Eq 12). One that
// failed open carries friction on the share D of the area that it has lost, starting from zero when it closes (Alfano & Sacco
// 2006, Int J Numer Meth Engng 68: friction on the damaged part). When a point fails while closed, both shares go on with their
// mean slip; the energy is convex in the slip, so the loss is never negative. On crossing δn = 0 β can only fall, which
// dissipates energy: the law has a potential. Failure in one mode always weakens the other (full coupling).
#pragma once

#include <cmath>
#include <numbers>

#include "solver/law/exponential.hpp"
#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

/// D of the open branch at a load λ ≥ 1 in a direction in which q = kt δn² + ks δs² is `stiffness` λ².
inline double consistent_damage(const ContactLaw& law, double load, double stiffness) {
    constexpr double e = std::numbers::e;
    // The work along a straight path is `stiffness` · [(1 − 2/e) + (λu − 1)/(2 e)] = Gf.
    const double range = 2 * e * (law.gf / stiffness - (1 - 2 / e));
    return range > load - 1 ? (load - 1) / range : 1.0;
}

struct Consistent {
    static constexpr LawDescription description{.variant = LawVariant::consistent,
                                                .name = "consistent",
                                                .meaning = "one damage variable, an energy everywhere",
                                                .potential = true,
                                                .fracture_energy = true,
                                                .open_shear_strength = true};
    static constexpr bool damages_intact = true;
    /// In pure opening. A direction in which the path to the peak takes more than Gf has no softening and takes that.
    static FractureEnergies min_energies(const ContactLaw& law) { return {law.tc * law.dct * (std::numbers::e - 2), 0}; }
    static void complete(ContactLaw& law) {
        law.stiffest_shear = law.ks;
        law.inv_dso = law.ks / (std::numbers::e * law.open_shear_strength);
    }

    /// Up to the peak cohesion responds as that of an intact point; beyond it, it softens (open) or is lost (closed). Friction of
    /// a closed point responds as that of a residual point.
    static void advance(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const bool open = to.opening >= 0;
        const double load = load_at(law, to.opening, to.sliding);
        double frictional_shear = 0;
        if (!open) {
            const ResidualResponse friction = residual_response(law, residual_point(h, to));
            frictional_shear = friction.shear;
            h.slip = friction.slip;
            r.dissipation.friction += h.friction_share * friction.friction;
        }
        if (load <= 1) {
            const IntactResponse cohesion = intact(law, intact_point(h, to));
            h.integrity = cohesion.integrity;
            r.dissipation.fracture += cohesion.fracture;
        } else if (open) {
            soften(law, to, load, r);
        } else if (h.integrity > 0) {
            frictional_shear = lose_cohesion(law, to, frictional_shear, r);
        }
        const double shear = h.integrity * law.ks * to.sliding;
        r.traction = open ? ContactTraction{h.integrity * law.kt * to.opening, shear}
                          : ContactTraction{law.kt * to.opening, shear + h.friction_share * frictional_shear};
        h.separated = h.separated || (open && h.integrity == 0);
        h.motion = to;
    }
    /// A contact closes: the normal traction is zero there, so friction starts from zero.
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
    /// Damage before the peak, on either branch.
    static IntactResponse intact(const ContactLaw& law, const IntactPoint& p) {
        const double load = load_at(law, p.opening, p.sliding);
        const double integrity = std::min(p.integrity, exp_of_minus(load));
        return {(p.opening >= 0 ? integrity : 1.0) * law.kt * p.opening, integrity * law.ks * p.sliding,
                load <= 1 ? stays_on_its_side(p) : 0.0, integrity, energy_of_fall(law, p, p.integrity - integrity)};
    }

private:
    /// λ of the branch that a motion is on.
    static double load_at(const ContactLaw& law, double opening, double sliding) {
        const double x = std::max(opening, 0.0) * law.inv_dct;
        const double y = sliding * (opening >= 0 ? law.inv_dso : law.inv_dcs);
        return std::sqrt(x * x + y * y);
    }
    /// q = kt⟨δn⟩² + ks δs²; the energy of cohesion is ½ β q.
    static double cohesive_form(const ContactLaw& law, double opening, double sliding) {
        const double opened = std::max(opening, 0.0);
        return law.kt * opened * opened + law.ks * sliding * sliding;
    }
    /// Energy that a fall of β takes from a point while it moves, at the mean of q before and after, J/m².
    static double energy_of_fall(const ContactLaw& law, const IntactPoint& p, double fall) {
        return 0.25 * (cohesive_form(law, p.old_opening, p.old_sliding) + cohesive_form(law, p.opening, p.sliding)) * fall;
    }
    /// Past the peak of the open branch: β follows the softening curve, and the lost share of the area will carry friction.
    static void soften(const ContactLaw& law, const ContactMotion& to, double load, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double lost = consistent_damage(law, load, cohesive_form(law, to.opening, to.sliding) / (load * load));
        const double integrity = std::min(h.integrity, (1 - lost) / (std::numbers::e * load));
        mark_failed(h, CrackMode::tensile);
        h.friction_share = std::max(h.friction_share, lost);
        r.dissipation.fracture += energy_of_fall(law, intact_point(h, to), h.integrity - integrity);
        h.integrity = integrity;
    }
    /// Past the peak of the closed branch: the cohesive share goes on with friction, from the traction it had.
    /// \return the traction of friction on the whole area, Pa
    static double lose_cohesion(const ContactLaw& law, const ContactMotion& to, double old_friction, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double limit = friction_limit(law, to);
        const double share = 1 - h.friction_share;
        const double carried = std::clamp(h.integrity * law.ks * to.sliding / share, -limit, limit);
        const double stored =
            h.integrity * law.ks * to.sliding * to.sliding + h.friction_share * old_friction * old_friction / law.ks;
        h.slip = h.friction_share * h.slip + share * (to.sliding - carried / law.ks);
        h.integrity = 0;
        h.friction_share = 1;
        mark_failed(h, CrackMode::shear);
        const double friction = law.ks * (to.sliding - h.slip);
        r.dissipation.fracture += 0.5 * (stored - friction * friction / law.ks);
        return friction;
    }
};

}  // namespace graincrack::contact_law
