// The variant `continuous`: single-valued before damage.
//
// Open: λ = √((δn/δct)² + (δs/δcs)²); (σn, τ) = (kt δn, ks δs) e^(−λ) up to λ = 1, where δpk = max(δct, |δ|); then
// (σn, τ) = g (kt δn, ks δs), g = (1 − D)(δpk/δmax)/e, D = (δmax − δpk)/(δut − δct).
//
// On open paths before damage there is no potential unless cc = tc √κ: the work of the part of the traction that is not the
// gradient of an energy is booked as non-conservative work.
#pragma once

#include "solver/law/compression.hpp"

namespace graincrack::contact_law {

/// q = kt δn² + ks δs², the quadratic form of all open energies.
inline double quadratic_form(const ContactLaw& law, const ContactMotion& m) {
    return law.kt * m.opening * m.opening + law.ks * m.sliding * m.sliding;
}
inline double lambda_squared(const ContactLaw& law, const ContactMotion& m) {
    const double x = m.opening * law.inv_dct;
    const double y = m.sliding * law.inv_dcs;
    return x * x + y * y;
}
inline double magnitude(const ContactMotion& m) { return std::sqrt(m.opening * m.opening + m.sliding * m.sliding); }
inline double continuous_damage(const ContactLaw& law, double max_displacement, double peak_displacement) {
    const double range = law.dut - law.dct;
    return range > 0 ? std::min(1.0, (max_displacement - peak_displacement) / range)
                     : (max_displacement > peak_displacement ? 1.0 : 0.0);
}
/// g: secant stiffness over initial stiffness after failure.
inline double continuous_reduction(const ContactLaw& law, const ContactHistory& h) {
    return (1 - continuous_damage(law, h.max_displacement, h.peak_displacement)) * (h.peak_displacement / h.max_displacement) /
           std::numbers::e;
}
/// Work per area of the non-gradient part of the traction between two open motions before failure (midpoint rule):
/// with ψ = q h(λ), T − ∇ψ = (e^(−λ)/2 − h)(∇q − (q/λ²)∇λ²).
inline double continuous_non_conservative_work(const ContactLaw& law, const ContactMotion& from, const ContactMotion& to) {
    const ContactMotion mid{0.5 * (from.opening + to.opening), 0.5 * (from.sliding + to.sliding)};
    const double l2 = lambda_squared(law, mid);
    if (l2 == 0) return 0;
    const double lambda = std::sqrt(l2);
    const double e = exp_of_minus(lambda);
    const double ratio = quadratic_form(law, mid) / l2;
    const double dn = to.opening - from.opening;
    const double ds = to.sliding - from.sliding;
    const double gradient = 2 * ((law.kt - ratio * law.inv_dct * law.inv_dct) * mid.opening * dn +
                                 (law.ks - ratio * law.inv_dcs * law.inv_dcs) * mid.sliding * ds);
    return (0.5 * e - exponential_energy(lambda, e)) * gradient;
}

struct Continuous : PaperLaw<Continuous> {
    static constexpr LawDescription description{.variant = LawVariant::continuous,
                                                .name = "continuous",
                                                .meaning = "single-valued before damage; shear strength c_c while open",
                                                .coupling = true,
                                                .parameters = {&ContactParameters::fracture_energy}};
    static void complete(ContactLaw& law) { law.stiffest_shear = law.ks; }

    static void advance_open(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double l2 = lambda_squared(law, to);
        const double q = quadratic_form(law, to);
        double reduction = 0;
        if (!h.failed_open) {
            r.dissipation.non_conservative_work += continuous_non_conservative_work(law, h.motion, to);
            const double lambda = std::sqrt(l2);
            reduction = exp_of_minus(lambda);
            if (lambda > 1) {
                const double stored = q * exponential_energy(lambda, reduction);
                mark_failed(h, CrackMode::tensile);
                h.peak_displacement = std::max(law.dct, magnitude(to) / lambda);  // where the step passed λ = 1
                h.max_displacement = std::max(h.peak_displacement, magnitude(to));
                reduction = continuous_reduction(law, h);
                r.dissipation.fracture += stored - 0.5 * reduction * q;
            }
        } else {
            const double before = continuous_reduction(law, h);
            h.max_displacement = std::max(h.max_displacement, magnitude(to));
            reduction = continuous_reduction(law, h);
            r.dissipation.fracture += 0.25 * (quadratic_form(law, h.motion) + q) * (before - reduction);
        }
        h.separated = h.separated || (h.failed_open && reduction == 0);
        r.traction = {law.kt * reduction * to.opening, law.ks * reduction * to.sliding};
    }
    static double open_energy(const ContactLaw& law, const ContactHistory& h) {
        if (h.failed_open) return 0.5 * continuous_reduction(law, h) * quadratic_form(law, h.motion);
        const double lambda = std::sqrt(lambda_squared(law, h.motion));
        return quadratic_form(law, h.motion) * exponential_energy(lambda, exp_of_minus(lambda));
    }
    static double open_damage(const ContactLaw& law, const ContactHistory& h) {
        return h.failed_open ? continuous_damage(law, h.max_displacement, h.peak_displacement) : 0;
    }
    /// Holds for closed points only: open ones book non-conservative work.
    static IntactResponse intact(const ContactLaw& law, const IntactPoint& p) {
        const double load = std::sqrt(law.inv_dcs * law.inv_dcs * p.sliding * p.sliding);
        return {law.kt * p.opening, law.ks * exp_of_minus(load) * p.sliding,
                load <= 1 && p.opening < 0 ? stays_on_its_side(p) : 0.0};
    }
};

}  // namespace graincrack::contact_law
