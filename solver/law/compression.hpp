// The closed branch of the readings literal, scaled and continuous, and what failure in one mode does to the other.
//
// σn = kt δn. Cohesive: τ = ks δs e^(−|δs|/δcs) until |δs| = δcs (Eq 10). Then cohesion is lost at once and friction is left.
//
// Coupling `full`: failure in either mode is loss of cohesion in both; a contact that failed in shear under compression
// (where Eq 10 has no softening) carries nothing when it opens; one that failed open carries compression and friction when
// it closes. Coupling `none`: each branch knows its own failure only.
#pragma once

#include <cmath>
#include <numbers>

#include "solver/law/exponential.hpp"
#include "solver/law/friction.hpp"

namespace graincrack::contact_law {

/// [1 − (1 + x) e^(−x)] / x²: stored energy of the exponential branch over (stiffness · displacement²).
inline double exponential_energy(double x, double exp_minus_x) {
    if (x < 0.02) {  // series; the next term, x⁴/144, is below 1.2e-9 of the first
        return 0.5 - x * (1.0 / 3.0 - x * (1.0 / 8.0 - x * (1.0 / 30.0)));
    }
    return (1 - (1 + x) * exp_minus_x) / (x * x);
}

/// True if the closed contact carries friction only.
inline bool is_frictional(const ContactLaw& law, const ContactHistory& h) {
    return h.failed_closed || (law.coupling == Coupling::full && h.failed_open);
}
/// True if the open contact carries nothing because of how it failed closed.
inline bool is_lost_open(const ContactLaw& law, const ContactHistory& h) {
    return law.coupling == Coupling::full && h.failed_closed;
}

/// What the three readings have in common.
struct PaperCompression {
    static constexpr bool damages_intact = false;
    /// Eq 14 with δut = δct: the softening branch is a fall.
    static FractureEnergies min_energies(const ContactLaw& law) { return {law.tc * law.dct * (std::numbers::e - 2), 0}; }
    static void advance_closed(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        r.traction.normal = law.kt * to.opening;
        if (is_frictional(law, r.history)) {
            slide(law, to, friction_limit(law, to), r);
            r.history.motion = to;
            return;
        }
        const double y = std::abs(to.sliding) * law.inv_dcs;
        const double e = exp_of_minus(y);
        if (y <= 1) {
            r.traction.shear = law.ks * to.sliding * e;
            r.history.motion = to;
            return;
        }
        // The peak is passed: cohesion is lost at once, τ ← clip(τ + ks Δδs, ±σres) (Eqs 10, 12).
        const double old_y = std::abs(r.history.motion.sliding) * law.inv_dcs;
        const double old_shear = law.ks * r.history.motion.sliding * exp_of_minus(old_y);
        const double limit = friction_limit(law, to);
        r.traction.shear = std::clamp(old_shear + law.ks * (to.sliding - r.history.motion.sliding), -limit, limit);
        r.history.slip = to.sliding - r.traction.shear / law.ks;
        mark_failed(r.history, CrackMode::shear);
        r.dissipation.fracture +=
            law.ks * to.sliding * to.sliding * exponential_energy(y, e) - 0.5 * r.traction.shear * r.traction.shear / law.ks;
        r.history.motion = to;
    }
    /// A contact closes: no normal traction yet, so no friction.
    static void close(const ContactLaw& law, ContactHistory& h) {
        if (is_frictional(law, h)) {
            h.slip = h.motion.sliding;
        }
    }
    static double closed_energy(const ContactLaw& law, const ContactHistory& h) {
        const ContactMotion& m = h.motion;
        const double normal = 0.5 * law.kt * m.opening * m.opening;
        if (is_frictional(law, h)) {
            const double elastic = m.sliding - h.slip;
            return normal + 0.5 * law.ks * elastic * elastic;
        }
        const double y = std::abs(m.sliding) * law.inv_dcs;
        return normal + law.ks * m.sliding * m.sliding * exponential_energy(y, exp_of_minus(y));
    }
    static bool is_residual(const ContactLaw& law, const ContactHistory& h) { return is_lost_open(law, h); }
    /// An open contact of which nothing is left.
    static void advance_lost(const ContactMotion& to, ContactResponse& r) {
        r.history.separated = true;
        r.traction = {};
        r.history.motion = to;
    }
};

}  // namespace graincrack::contact_law
