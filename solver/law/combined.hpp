// `combined` (share/doc/laws.md): the combined single and smeared crack model of FEM/DEM codes (Munjiza, Andrews & White 1999,
// Int J Numer Meth Engng 44, 41–57; in shear as Y-Geo, Mahabadi et al. 2012, Int J Geomech 12), made a law with an energy.
//
//   σn = z tc P(δn/o_p) while open, kt δn while closed;  τ = z cc P(δs/s_p), P(x) = x (2 − |x|), 1 at the peak
//   o_p = 2 tc/kt, s_p = 2 cc/ks                         so that the parabola starts with kt and ks
//   z = [1 − (a+b−1)/(a+b) e^(D (a+cb)/((a+b)(1−a−b)))] [a (1−D) + b (1−D)^c],  a = 0.63, b = 1.8, c = 6
//   D = √(⟨(o−o_p)/(o_r−o_p)⟩² + ⟨(s−s_p)/(s_r−s_p)⟩²)   with the largest opening o and sliding s so far, 0 to 1
//
// Past the peak a point unloads and reloads on the secant, P(x) = x/(largest x). o_r and s_r give the curves the areas G_I and
// G_II: ∫σ do = tc o_p (2/3 + I (o_r−o_p)/o_p), I = ∫0^1 z dD. A closed point that has failed bears friction beside its cohesion,
// on all of its area, from zero: τ += ks (δs − slip) within ±σres.
//
// Energy: z (tc o_p E(δn/o_p) + cc s_p E(δs/s_p)) + ½ kt⟨−δn⟩² + ½ ks (δs − slip)², E = ∫P. Each history variable only lowers it.
#pragma once

#include <cmath>

#include "solver/law/exponential.hpp"
#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

/// ∫0^1 z dD = a/2 + b/7 − A (a J1 + b J6), A = (a+b−1)/(a+b), Jn = ∫0^1 (1−D)^n e^(−kD) dD = (1 − n J(n−1))/k,
/// J0 = (1 − e^(−k))/k, k = (a+6b)/((a+b)(a+b−1)).
inline constexpr double softening_area = 0.386307294743942625;

/// z(D): remaining fraction of the strengths at a damage D ≥ 0.
inline double munjiza_softening(double damage) {
    constexpr double a = 0.63;
    constexpr double b = 1.8;
    constexpr double rate = (a + 6 * b) / ((a + b) * (a + b - 1));
    const double left = std::max(0.0, 1 - damage);
    const double cube = left * left * left;
    return (1 - (a + b - 1) / (a + b) * exp_of_minus(rate * damage)) * (a * left + b * cube * cube);
}

struct Combined {
    static constexpr LawDescription description{
        .variant = LawVariant::combined,
        .name = "combined",
        .meaning = "softening of FEM/DEM codes with G_I and G_II",
        .potential = true,
        .friction_beside_cohesion = true,
        .parameters = {&ContactParameters::fracture_energy, &ContactParameters::mode_ii_fracture_energy,
                       &ContactParameters::residual_friction_angle, &ContactParameters::wear_slip}};
    static constexpr bool damages_intact = false;
    static constexpr bool remembers_largest = true;
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
    /// The cohesion of a point: the largest stretches, each 0 up to its peak and at least 1 past it, D and z.
    struct Cohesion {
        Stretch largest;
        double damage;  ///< D, above 1 when nothing is left
        double left;    ///< z
    };
    static Cohesion cohesion_at(const ContactLaw& law, const Stretch& largest) {
        const double x = std::max(0.0, largest.open - 1) / law.o_range;
        const double y = std::max(0.0, largest.slid - 1) / law.s_range;
        const double damage = std::sqrt(x * x + y * y);
        return {largest, damage, munjiza_softening(damage)};
    }
    static Cohesion cohesion_of(const ContactLaw& law, const ContactHistory& h) {
        return cohesion_at(law, {h.largest_open, h.largest_slid});
    }
    /// P(x) for x ≥ 0, on the secant once the peak has been passed.
    static double rise(double x, double largest) { return largest >= 1 ? x / largest : x * (2 - x); }
    /// E(x) = ∫P.
    static double rise_energy(double x, double largest) { return largest >= 1 ? 0.5 * x * x / largest : x * x * (1 - x / 3); }
    static double cohesive_energy(const ContactLaw& law, const Stretch& at, const Cohesion& c) {
        return c.left *
               (law.tc * law.op * rise_energy(at.open, c.largest.open) + law.cc * law.sp * rise_energy(at.slid, c.largest.slid));
    }
    /// The tangent of the friction angle: φc while all cohesion is there, φ_r when it is gone, between them in proportion to 1 −
    /// D.
    static double tan_friction(const ContactLaw& law, double damage) {
        return law.residual_tan_phi + (law.tan_phi - law.residual_tan_phi) * (1 - std::min(1.0, damage));
    }
    /// 1 if a stretch passes its peak, else 0.
    static double passes_peak(double stretch, double largest) { return stretch > 1 && largest < 1 ? 1.0 : 0.0; }

    /// Cohesion past a peak, and friction beside it while closed.
    GRAINCRACK_INLINE static SofteningResponse softening(const ContactLaw& law, const MovedPoint& p) {
        const bool closed = p.opening < 0;
        const Stretch from = stretch_of(law, {p.old_opening, p.old_sliding});
        const Stretch at = stretch_of(law, {p.opening, p.sliding});
        const Cohesion old = cohesion_at(law, {p.largest_open, p.largest_slid});
        const Cohesion now = cohesion_at(law, {p.largest_open < 1 ? 0 : std::max(p.largest_open, at.open),
                                               p.largest_slid < 1 ? 0 : std::max(p.largest_slid, at.slid)});
        const double limit = -law.kt * std::min(p.opening, 0.0) * tan_friction(law, now.damage);
        const FrictionReturn friction = friction_return(law.ks, p.old_sliding, p.sliding, p.slip, limit);
        const double open = now.left * law.tc * rise(at.open, now.largest.open);
        const double shear = std::copysign(now.left * law.cc * rise(at.slid, now.largest.slid), p.sliding);
        const double passes = passes_peak(at.open, p.largest_open) + passes_peak(at.slid, p.largest_slid);
        return {.normal = closed ? law.kt * p.opening : open,
                .shear = shear + (closed ? friction.shear : 0.0),
                .integrity = p.integrity,
                .slip = closed ? friction.slip : p.slip,
                // The fall of the energy with history, at the mean of both motions: each part is at least zero.
                .fracture = 0.5 * (cohesive_energy(law, from, old) - cohesive_energy(law, from, now) +
                                   cohesive_energy(law, at, old) - cohesive_energy(law, at, now)),
                .friction = closed ? friction.dissipated : 0.0,
                .holds = passes == 0 && now.left > 0 ? stays_on_its_side(p) : 0.0,
                .remaining_cohesion = now.left,
                .largest_open = now.largest.open,
                .largest_slid = now.largest.slid};
    }
    /// Notes the peaks that a point passes. Friction starts from zero in the step in which a closed point fails.
    static void pass_peaks(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        constexpr double lost_at_peak = 2.0 / 3 - 0.5;  // from the parabola's energy to the secant's
        ContactHistory& h = r.history;
        const Stretch at = stretch_of(law, to);
        const double left = cohesion_of(law, h).left;
        const CrackMode mode = to.opening >= 0 ? CrackMode::tensile : CrackMode::shear;
        if (!h.failed() && to.opening < 0) h.slip = to.sliding;
        if (passes_peak(at.open, h.largest_open) != 0) {
            mark_failed(h, mode);
            r.dissipation.fracture += lost_at_peak * left * law.tc * law.op;
            h.largest_open = 1;
        }
        if (passes_peak(at.slid, h.largest_slid) != 0) {
            mark_failed(h, mode);
            r.dissipation.fracture += lost_at_peak * left * law.cc * law.sp;
            h.largest_slid = 1;
        }
    }
    static void advance(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        if (!h.failed() && advance_intact<Combined>(law, to, r)) return;
        pass_peaks(law, to, r);
        h.separated = advance_softening<Combined>(law, to, r) == 0 || h.separated;
    }
    /// A contact closes: the normal traction is zero there, so friction starts from zero.
    static void close(const ContactLaw& /*law*/, ContactResponse& r) { r.history.slip = r.history.motion.sliding; }

    static double stored_energy(const ContactLaw& law, const ContactHistory& h) {
        const double cohesive = cohesive_energy(law, stretch_of(law, h.motion), cohesion_of(law, h));
        if (h.motion.opening >= 0) return cohesive;
        const double elastic = h.failed() ? h.motion.sliding - h.slip : 0;
        return cohesive + 0.5 * (law.kt * h.motion.opening * h.motion.opening + law.ks * elastic * elastic);
    }
    static double damage(const ContactLaw& law, const ContactHistory& h) { return std::min(1.0, cohesion_of(law, h).damage); }
    static double remaining_cohesion(const ContactLaw& law, const ContactHistory& h) { return cohesion_of(law, h).left; }
    static bool is_residual(const ContactLaw& law, const ContactHistory& h) { return h.failed() && damage(law, h) >= 1; }
    static IntactResponse intact(const ContactLaw& law, const MovedPoint& p) {
        const double x = std::max(0.0, p.opening) * law.inv_op;
        const double y = std::abs(p.sliding) * law.inv_sp;
        return {law.kt * p.opening * (1 - 0.5 * x), law.ks * p.sliding * (1 - 0.5 * y), x <= 1 && y <= 1 ? 1.0 : 0.0};
    }
};

}  // namespace graincrack::contact_law
