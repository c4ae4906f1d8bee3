// The closed branch of the variants literal, scaled and continuous, and the coupling of failure in one mode to the other.
//
// σn = kt δn. Cohesive: τ = ks δs e^(−|δs|/δcs) until |δs| = δcs (Eq 10). Then cohesion is lost at once and friction is left.
//
// Coupling `full`: failure in either mode is loss of cohesion in both. A contact that failed in shear under compression, where
// Eq 10 has no softening, carries nothing when it opens; one that failed open carries compression and friction when it closes.
// Coupling `none`: failure in one mode leaves the other branch as it was.
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

/// True if the closed contact carries compression and friction only.
inline bool is_frictional(const ContactLaw& law, const ContactHistory& h) {
    return h.failed_closed || (law.coupling == Coupling::full && h.failed_open);
}
/// True if the open contact carries nothing because it failed while closed.
inline bool is_lost_open(const ContactLaw& law, const ContactHistory& h) {
    return law.coupling == Coupling::full && h.failed_closed;
}

/// What the three variants have in common. `Open` adds the open branch: `advance_open`, `open_energy` and `open_damage`, which
/// are asked only of points that may carry tension.
template <class Open>
struct PaperLaw {
    static constexpr bool damages_intact = false;
    /// Eq 14 with δut = δct: the softening branch is a sudden fall.
    static FractureEnergies min_energies(const ContactLaw& law) { return {law.tc * law.dct * (std::numbers::e - 2), 0}; }

    static void advance(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        const bool open = to.opening >= 0;
        if (open ? is_lost_open(law, r.history) : is_frictional(law, r.history)) {
            advance_residual(law, to, r);
            return;
        }
        const bool has_failed = open ? r.history.failed_open : r.history.failed_closed;
        if (!has_failed && advance_intact<Open>(law, to, r)) return;
        open ? Open::advance_open(law, to, r) : lose_cohesion(law, to, r);
        r.history.motion = to;
    }
    /// A contact closes: the normal traction is zero there, so friction starts from zero.
    static void close(const ContactLaw& law, ContactHistory& h) {
        if (is_frictional(law, h)) h.slip = h.motion.sliding;
    }
    static double stored_energy(const ContactLaw& law, const ContactHistory& h) {
        if (h.motion.opening < 0) return closed_energy(law, h);
        return is_lost_open(law, h) ? 0 : Open::open_energy(law, h);
    }
    static double damage(const ContactLaw& law, const ContactHistory& h) {
        return is_lost_open(law, h) ? 1 : Open::open_damage(law, h);
    }
    /// Nothing once the cohesion of the closed branch has been lost, whichever the coupling is.
    static double remaining_cohesion(const ContactLaw& law, const ContactHistory& h) {
        return h.failed_closed ? 0 : 1 - Open::open_damage(law, h);
    }
    static bool is_residual(const ContactLaw& law, const ContactHistory& h) { return is_lost_open(law, h); }

private:
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
};

}  // namespace graincrack::contact_law
