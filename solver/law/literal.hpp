// `literal`: the law of Kazerani & Zhao (2014) as printed.
//
// Open: δeff = √(δn² + δs²) (Eq 2); (σn, τ) = (σ/δeff)(δn, δs) (Eq 13), where σ = kt δeff e^(−δeff/δct) up to δct, then softening
// tc (1 − D) with secant unloading (Eqs 7–9).
// Closed: σn = kt δn. Cohesive: τ = ks δs e^(−|δs|/δcs) until |δs| = δcs (Eq 10). Then cohesion is lost at once and friction is
// left.
//
// Failure in either mode is loss of cohesion in both. A contact that failed in shear under compression, where Eq 10 has no
// softening, carries nothing when it opens; one that failed open carries compression and friction when it closes.
//
// The stored energies of the two branches differ at δn = 0: the difference is booked as non-conservative work.
#pragma once

#include <cmath>
#include <numbers>

#include "solver/law/exponential.hpp"
#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

/// [1 − (1 + x) e^(−x)] / x²: stored energy of the exponential branch over (stiffness · displacement²).
inline double exponential_energy(double x, double exp_minus_x) {
    if (x < 0.02) {  // series; the next term, x⁴/144, is below 1.2e-9 of the first
        return 0.5 - x * (1.0 / 3.0 - x * (1.0 / 8.0 - x * (1.0 / 30.0)));
    }
    return (1 - (1 + x) * exp_minus_x) / (x * x);
}

struct Literal {
    static constexpr LawDescription description{.variant = LawVariant::literal,
                                                .name = "literal",
                                                .meaning = "the text as printed",
                                                .parameters = {&ContactParameters::fracture_energy}};
    static constexpr bool damages_intact = false;
    /// Eq 14 with δut = δct: the softening branch is a sudden fall.
    static FractureEnergies min_energies(const ContactLaw& law) { return {law.tc * law.dct * (std::numbers::e - 2), 0}; }
    static void complete(ContactLaw& law) { law.stiffest_shear = std::max(law.ks, law.kt); }

    static void advance(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        const bool open = to.opening >= 0;
        if (open ? r.history.failed_closed : r.history.failed()) {
            advance_residual(law, to, r);
            return;
        }
        if (!r.history.failed() && advance_intact<Literal>(law, to, r)) return;
        open ? soften(law, to, r) : lose_cohesion(law, to, r);
        r.history.motion = to;
    }
    /// A contact closes: the normal traction is zero there, so friction starts from zero.
    static void close(const ContactLaw& /*law*/, ContactResponse& r) {
        if (r.history.failed()) r.history.slip = r.history.motion.sliding;
    }
    static double stored_energy(const ContactLaw& law, const ContactHistory& h) {
        if (h.motion.opening < 0) return closed_energy(law, h);
        return h.failed_closed ? 0 : open_energy(law, h);
    }
    static double damage(const ContactLaw& law, const ContactHistory& h) {
        if (!h.failed_open || h.failed_closed) return h.failed_closed ? 1 : 0;
        return law.dut > law.dct ? std::min(1.0, (h.max_displacement - law.dct) / (law.dut - law.dct)) : 1.0;
    }
    static bool is_residual(const ContactLaw& /*law*/, const ContactHistory& h) { return h.failed_closed; }
    static IntactResponse intact(const ContactLaw& law, const MovedPoint& p) {
        const bool open = p.opening >= 0;
        const double normal_weight = law.inv_dct * law.inv_dct;
        const double shear_weight = open ? law.inv_dct * law.inv_dct : law.inv_dcs * law.inv_dcs;
        const double load =
            std::sqrt((open ? normal_weight : 0.0) * p.opening * p.opening + shear_weight * p.sliding * p.sliding);
        const double decay = exp_of_minus(load);
        return {law.kt * (open ? decay : 1.0) * p.opening, (open ? law.kt : law.ks) * decay * p.sliding,
                load <= 1 ? stays_on_its_side(p) : 0.0};
    }

private:
    static double effective_displacement(const ContactMotion& m) {
        return std::sqrt(m.opening * m.opening + m.sliding * m.sliding);
    }
    /// Secant stiffness at δmax: tc (1 − D)/δmax, Eqs 7, 9.
    static double reduced_stiffness(const ContactLaw& law, double max_displacement) {
        return max_displacement >= law.dut ? 0 : law.tc * (law.dut - max_displacement) / ((law.dut - law.dct) * max_displacement);
    }
    /// Dissipated on the path to δmax ≥ δct: the area under the curve less the recoverable triangle, J/m².
    static double softening_dissipation(const ContactLaw& law, double max_displacement) {
        const double m = std::min(max_displacement, law.dut);
        const double past = m - law.dct;
        const double range = law.dut - law.dct;
        const double area =
            law.tc * law.dct * (std::numbers::e - 2) + (range > 0 ? law.tc * (past - past * past / (2 * range)) : 0);
        return area - 0.5 * reduced_stiffness(law, m) * m * m;
    }
    /// At and past the peak of the open branch.
    static void soften(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double d = effective_displacement(to);
        const double before = h.failed_open ? softening_dissipation(law, h.max_displacement) : 0;
        if (!h.failed_open) {
            mark_failed(h, CrackMode::tensile);
            h.max_displacement = d;
        }
        if (d >= h.max_displacement) {
            h.max_displacement = d;
            r.dissipation.fracture += softening_dissipation(law, d) - before;
        }
        h.separated = h.separated || h.max_displacement >= law.dut;
        const double stiffness = reduced_stiffness(law, h.max_displacement);
        r.traction = {stiffness * to.opening, stiffness * to.sliding};
    }
    /// Past the peak of the closed branch: τ ← clip(τ + ks Δδs, ±σres) (Eqs 10, 12).
    static void lose_cohesion(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        r.traction.normal = law.kt * to.opening;
        const double y = std::abs(to.sliding) * law.inv_dcs;
        const double decay = exp_of_minus(y);
        const double old_sliding = r.history.motion.sliding;
        const double old_shear = law.ks * old_sliding * exp_of_minus(std::abs(old_sliding) * law.inv_dcs);
        const double limit = friction_limit(law, to);
        r.traction.shear = std::clamp(old_shear + law.ks * (to.sliding - old_sliding), -limit, limit);
        r.history.slip = to.sliding - r.traction.shear / law.ks;
        mark_failed(r.history, CrackMode::shear);
        r.dissipation.fracture +=
            law.ks * to.sliding * to.sliding * exponential_energy(y, decay) - 0.5 * r.traction.shear * r.traction.shear / law.ks;
    }
    static double open_energy(const ContactLaw& law, const ContactHistory& h) {
        const double d = effective_displacement(h.motion);
        if (h.failed_open) return 0.5 * reduced_stiffness(law, h.max_displacement) * d * d;
        const double x = d * law.inv_dct;
        return law.kt * d * d * exponential_energy(x, exp_of_minus(x));
    }
    static double closed_energy(const ContactLaw& law, const ContactHistory& h) {
        const ContactMotion& m = h.motion;
        const double normal = 0.5 * law.kt * m.opening * m.opening;
        if (h.failed()) {
            const double elastic = m.sliding - h.slip;
            return normal + 0.5 * law.ks * elastic * elastic;
        }
        const double y = std::abs(m.sliding) * law.inv_dcs;
        return normal + law.ks * m.sliding * m.sliding * exponential_energy(y, exp_of_minus(y));
    }
};

}  // namespace graincrack::contact_law
