// The variants `literal` and `scaled`: one effective displacement in the open branch.
//
// δeff = √(δn² + w δs²) with w = 1 (Eq 2) or κ = ks/kt; (σn, τ) = (σ/δeff)(δn, w δs) (Eq 13), where σ = kt δeff e^(−δeff/δct)
// up to δct, then softening tc (1 − D) with secant unloading (Eqs 7–9).
//
// The stored energies of the two branches differ at δn = 0: the difference is booked as non-conservative work.
#pragma once

#include "solver/law/compression.hpp"

namespace graincrack::contact_law {

inline double effective_displacement(const ContactLaw& law, const ContactMotion& m) {
    return std::sqrt(m.opening * m.opening + law.w * m.sliding * m.sliding);
}
/// Secant stiffness at δmax: tc (1 − D)/δmax, Eqs 7, 9.
inline double reduced_stiffness(const ContactLaw& law, double max_displacement) {
    return max_displacement >= law.dut ? 0 : law.tc * (law.dut - max_displacement) / ((law.dut - law.dct) * max_displacement);
}
/// Dissipated on the path to δmax ≥ δct: the area under the curve less the recoverable triangle, J/m².
inline double softening_dissipation(const ContactLaw& law, double max_displacement) {
    const double m = std::min(max_displacement, law.dut);
    const double past = m - law.dct;
    const double range = law.dut - law.dct;
    const double area = law.tc * law.dct * (std::numbers::e - 2) + (range > 0 ? law.tc * (past - past * past / (2 * range)) : 0);
    return area - 0.5 * reduced_stiffness(law, m) * m * m;
}

struct Effective : PaperLaw<Effective> {
    static void advance_open(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double d = effective_displacement(law, to);
        const double before = h.failed_open ? softening_dissipation(law, h.max_displacement) : 0;
        if (!h.failed_open) {
            mark_failed(h, CrackMode::tensile);
            h.peak_displacement = law.dct;
            h.max_displacement = d;
        }
        if (d >= h.max_displacement) {
            h.max_displacement = d;
            r.dissipation.fracture += softening_dissipation(law, d) - before;
        }
        h.separated = h.separated || h.max_displacement >= law.dut;
        const double stiffness = reduced_stiffness(law, h.max_displacement);
        r.traction = {stiffness * to.opening, stiffness * law.w * to.sliding};
    }
    static double open_energy(const ContactLaw& law, const ContactHistory& h) {
        const double d = effective_displacement(law, h.motion);
        if (h.failed_open) return 0.5 * reduced_stiffness(law, h.max_displacement) * d * d;
        const double x = d * law.inv_dct;
        return law.kt * d * d * exponential_energy(x, exp_of_minus(x));
    }
    static double open_damage(const ContactLaw& law, const ContactHistory& h) {
        if (!h.failed_open) return 0;
        return law.dut > law.dct ? std::min(1.0, (h.max_displacement - law.dct) / (law.dut - law.dct)) : 1.0;
    }
    static IntactResponse intact(const ContactLaw& law, const IntactPoint& p) {
        const bool open = p.opening >= 0;
        const double normal_weight = law.inv_dct * law.inv_dct;
        const double shear_weight = open ? law.w * law.inv_dct * law.inv_dct : law.inv_dcs * law.inv_dcs;
        const double load =
            std::sqrt((open ? normal_weight : 0.0) * p.opening * p.opening + shear_weight * p.sliding * p.sliding);
        const double decay = exp_of_minus(load);
        return {law.kt * (open ? decay : 1.0) * p.opening, (open ? law.w * law.kt : law.ks) * decay * p.sliding,
                load <= 1 ? stays_on_its_side(p) : 0.0};
    }
};

struct Literal : Effective {
    static constexpr LawDescription description{.variant = LawVariant::literal,
                                                .name = "literal",
                                                .meaning = "the text as printed",
                                                .coupling = true,
                                                .parameters = {&ContactParameters::fracture_energy}};
    static void complete(ContactLaw& law) {
        law.w = 1;
        law.stiffest_shear = std::max(law.ks, law.kt);
    }
};
struct Scaled : Effective {
    static constexpr LawDescription description{.variant = LawVariant::scaled,
                                                .name = "scaled",
                                                .meaning = "the text with sliding weighted by ks/kt",
                                                .coupling = true,
                                                .parameters = {&ContactParameters::fracture_energy}};
    static void complete(ContactLaw& law) {
        law.w = law.ks / law.kt;
        law.stiffest_shear = std::max(law.ks, law.w * law.kt);
    }
};

}  // namespace graincrack::contact_law
