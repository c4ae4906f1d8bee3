// `combined`: the combined single and smeared crack model of FEM/DEM codes (Munjiza, Andrews & White 1999, Int J Numer Meth Engng
// 44, 41–57; in shear as Y-Geo, Mahabadi et al. 2012, Int J Geomech 12), made a law with an energy.
//
//   σn = z tc P(δn/o_p) while open, kt δn while closed;  τ = z cc P(δs/s_p), P(x) = x (2 − |x|), 1 at the peak
//   o_p = 2 tc/kt, s_p = 2 cc/ks                         so that the parabola starts with kt and ks
//   z = [1 − (a+b−1)/(a+b) e^(D (a+cb)/((a+b)(1−a−b)))] [a (1−D) + b (1−D)^c],  a = 0.63, b = 1.8, c = 6
//   D = √(⟨(o−o_p)/(o_r−o_p)⟩² + ⟨(s−s_p)/(s_r−s_p)⟩²)   with the largest opening o and sliding s so far, 0 to 1
//
// Before a peak a point is elastic along the parabola. Past the peak it unloads and reloads on the secant, P(x) = x/(largest x).
// o_r and s_r follow from the fracture energies: the area under the curve of pure opening is G_I, that of pure sliding G_II:
//
//   ∫σ do = tc o_p (2/3 + I (o_r−o_p)/o_p),  I = ∫0^1 z dD = 0.386307…
//
// A closed point that has failed in either mode bears friction beside its cohesion, on all of its area, starting from zero in the
// step in which it fails: τ += ks (δs − slip) within ±σres. The strength under compression is then nearly cc + |σn| tan φc, as in
// those codes. It is less by the fall of z while friction is mobilised, over a sliding of |σn| tan φc/ks.
//
// Energy: z (tc o_p E(δn/o_p) + cc s_p E(δs/s_p)) + ½ kt⟨−δn⟩² + ½ ks (δs − slip)², E = ∫P. Each of its history variables only
// lowers it, so dissipation is never negative. It is continuous at δn = 0, so the law has a potential. Failure in one mode always
// weakens the other (full coupling).
#pragma once

#include <cmath>

#include "solver/law/exponential.hpp"
#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

/// ∫0^1 z dD = a/2 + b/7 − A (a J1 + b J6), A = (a+b−1)/(a+b), Jn = ∫0^1 (1−D)^n e^(−kD) dD = (1 − n J(n−1))/k,
/// J0 = (1 − e^(−k))/k, k = (a+6b)/((a+b)(a+b−1)).
inline constexpr double softening_area = 0.386307294743942625;

/// z(D): remaining share of the strengths at a damage D ≥ 0.
inline double munjiza_softening(double damage) {
    constexpr double a = 0.63;
    constexpr double b = 1.8;
    constexpr double rate = (a + 6 * b) / ((a + b) * (a + b - 1));
    const double left = std::max(0.0, 1 - damage);
    const double cube = left * left * left;
    return (1 - (a + b - 1) / (a + b) * exp_of_minus(rate * damage)) * (a * left + b * cube * cube);
}

struct Combined {
    static constexpr LawDescription description{.variant = LawVariant::combined,
                                                .name = "combined",
                                                .meaning = "softening of FEM/DEM codes with G_I and G_II",
                                                .potential = true,
                                                .fracture_energy = true,
                                                .mode_ii_fracture_energy = true,
                                                .residual_friction = true};
    static constexpr bool damages_intact = false;
    /// The areas to the peaks.
    static FractureEnergies min_energies(const ContactLaw& law) { return {2.0 / 3 * law.tc * law.op, 2.0 / 3 * law.cc * law.sp}; }
    static void complete(ContactLaw& law) {
        law.stiffest_shear = 2 * law.ks;  // cohesion and friction side by side
        law.op = 2 * law.tc / law.kt;
        law.sp = 2 * law.cc / law.ks;
        law.inv_op = 1 / law.op;
        law.inv_sp = 1 / law.sp;
        law.o_range = (law.gf / (law.tc * law.op) - 2.0 / 3) / softening_area;
        law.s_range = (law.g2 / (law.cc * law.sp) - 2.0 / 3) / softening_area;
        law.softens_in_shear = true;
    }

    /// A motion over the displacements at the peaks.
    struct Stretch {
        double open, slid;  ///< ⟨δn⟩/o_p, |δs|/s_p
    };
    static Stretch stretch_of(const ContactLaw& law, const ContactMotion& m) {
        return {std::max(0.0, m.opening) * law.inv_op, std::abs(m.sliding) * law.inv_sp};
    }
    /// The cohesion of a point: the largest stretches, each 0 up to its peak and at least 1 past it, and z.
    struct Cohesion {
        Stretch largest;
        double left;
    };
    static double damage_at(const ContactLaw& law, const Stretch& largest) {
        const double x = std::max(0.0, largest.open - 1) / law.o_range;
        const double y = std::max(0.0, largest.slid - 1) / law.s_range;
        return std::sqrt(x * x + y * y);
    }
    static Cohesion cohesion_of(const ContactLaw& law, const ContactHistory& h) {
        const Stretch largest{h.largest_open, h.largest_slid};
        return {largest, munjiza_softening(damage_at(law, largest))};
    }
    /// P(x) for x ≥ 0, on the secant once the peak has been passed.
    static double rise(double x, double largest) { return largest >= 1 ? x / largest : x * (2 - x); }
    /// E(x) = ∫P.
    static double rise_energy(double x, double largest) { return largest >= 1 ? 0.5 * x * x / largest : x * x * (1 - x / 3); }
    static double cohesive_energy(const ContactLaw& law, const Stretch& at, const Cohesion& c) {
        return c.left *
               (law.tc * law.op * rise_energy(at.open, c.largest.open) + law.cc * law.sp * rise_energy(at.slid, c.largest.slid));
    }

    /// Of the friction angle: φc while all cohesion is there, φ_r when it is gone, between them in proportion to 1 − D.
    static double tan_friction(const ContactLaw& law, const ContactHistory& h) {
        return law.residual_tan_phi + (law.tan_phi - law.residual_tan_phi) * (1 - damage(law, h));
    }
    /// Friction beside the cohesion of a closed point. It starts from zero in the step in which the point fails.
    static void advance_friction(const ContactLaw& law, const ContactMotion& to, bool rubs, ContactResponse& r) {
        if (rubs) {
            slide(law, to, -law.kt * to.opening * tan_friction(law, r.history), r);
        } else {
            r.history.slip = to.sliding;
            r.traction.shear = 0;
        }
    }
    /// Moves the cohesion of a point to a motion on the same side of δn = 0. \return its traction, without compression
    static ContactTraction soften(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        constexpr double lost_at_peak = 2.0 / 3 - 0.5;  // from the parabola's energy to the secant's
        ContactHistory& h = r.history;
        const Stretch from = stretch_of(law, h.motion);
        const Stretch at = stretch_of(law, to);
        const CrackMode mode = to.opening >= 0 ? CrackMode::tensile : CrackMode::shear;
        Cohesion old = cohesion_of(law, h);
        if (at.open > 1 && old.largest.open < 1) {
            mark_failed(h, mode);
            r.dissipation.fracture += lost_at_peak * old.left * law.tc * law.op;
            old.largest.open = 1;
        }
        if (at.slid > 1 && old.largest.slid < 1) {
            mark_failed(h, mode);
            r.dissipation.fracture += lost_at_peak * old.left * law.cc * law.sp;
            old.largest.slid = 1;
        }
        h.largest_open = old.largest.open < 1 ? 0 : std::max(old.largest.open, at.open);
        h.largest_slid = old.largest.slid < 1 ? 0 : std::max(old.largest.slid, at.slid);
        const Cohesion now = cohesion_of(law, h);
        h.separated = h.separated || now.left == 0;
        // The fall of the energy with history, at the mean of both motions: each part is at least zero.
        r.dissipation.fracture += 0.5 * (cohesive_energy(law, from, old) - cohesive_energy(law, from, now) +
                                         cohesive_energy(law, at, old) - cohesive_energy(law, at, now));
        return {now.left * law.tc * rise(at.open, now.largest.open),
                std::copysign(now.left * law.cc * rise(at.slid, now.largest.slid), to.sliding)};
    }
    static void advance(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        const bool rubs = r.history.failed();
        if (!rubs && advance_intact<Combined>(law, to, r)) {
            return;
        }
        const ContactTraction cohesive = soften(law, to, r);
        if (to.opening >= 0) {
            r.traction = cohesive;
        } else {
            advance_friction(law, to, rubs, r);
            r.traction = {law.kt * to.opening, r.traction.shear + cohesive.shear};
        }
        r.history.motion = to;
    }
    /// A contact closes: the normal traction is zero there, so friction starts from zero.
    static void close(const ContactLaw& /*law*/, ContactHistory& h) { h.slip = h.motion.sliding; }

    static double stored_energy(const ContactLaw& law, const ContactHistory& h) {
        const double cohesive = cohesive_energy(law, stretch_of(law, h.motion), cohesion_of(law, h));
        if (h.motion.opening >= 0) {
            return cohesive;
        }
        const double elastic = h.failed() ? h.motion.sliding - h.slip : 0;
        return cohesive + 0.5 * (law.kt * h.motion.opening * h.motion.opening + law.ks * elastic * elastic);
    }
    static double damage(const ContactLaw& law, const ContactHistory& h) {
        return std::min(1.0, damage_at(law, cohesion_of(law, h).largest));
    }
    static double remaining_cohesion(const ContactLaw& law, const ContactHistory& h) { return cohesion_of(law, h).left; }
    static bool is_residual(const ContactLaw& law, const ContactHistory& h) { return h.failed() && damage(law, h) >= 1; }
    static IntactResponse intact(const ContactLaw& law, const IntactPoint& p) {
        const double x = std::max(0.0, p.opening) * law.inv_op;
        const double y = std::abs(p.sliding) * law.inv_sp;
        return {law.kt * p.opening * (1 - 0.5 * x), law.ks * p.sliding * (1 - 0.5 * y), x <= 1 && y <= 1 ? 1.0 : 0.0};
    }
};

}  // namespace graincrack::contact_law
