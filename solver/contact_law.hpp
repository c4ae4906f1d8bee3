// The cohesive contact law of Kazerani & Zhao (2014), §3.1, in its named readings: pure functions of motion and history.
//
// Signs: opening δn > 0 and tension σn > 0; sliding δs and shear traction τ are signed. Symbols as in the paper:
//
//   kt, ks   initial stiffnesses (Eqs 3–5)        δct = e tc/kt, δcs = e cc/ks   critical displacements (Eqs 8, 11)
//   tc, cc   tensile strength, cohesion           δut                           ultimate displacement (Eq 14)
//   φc       friction angle of a failed contact   κ = ks/kt
//
// Closed (δn < 0), all readings: σn = kt δn; cohesive: τ = ks δs e^(−|δs|/δcs) until |δs| = δcs (Eq 10); failed: friction,
// τ = ks (δs − slip) limited to ±σres, σres = −kt δn tan φc (Eqs 10, 12 as signed increments).
//
// Open (δn ≥ 0):
//   literal, scaled   δeff = √(δn² + w δs²) with w = 1 or κ (Eq 2); (σn, τ) = (σ/δeff)(δn, w δs) (Eq 13), where
//                     σ = kt δeff e^(−δeff/δct) up to δct, then softening tc (1 − D) with secant unloading (Eqs 7–9)
//   continuous        λ = √((δn/δct)² + (δs/δcs)²); (σn, τ) = (kt δn, ks δs) e^(−λ) up to λ = 1, where δpk = max(δct, |δ|);
//                     then (σn, τ) = g (kt δn, ks δs), g = (1 − D)(δpk/δmax)/e, D = (δmax − δpk)/(δut − δct)
//   consistent        see below
//
// Coupling `full`: failure in either mode is loss of cohesion in both; a contact that failed in shear under compression
// (where Eq 10 has no softening) carries nothing when it opens; one that failed open carries compression and friction when
// it closes. Coupling `none`: each branch knows its own failure only.
//
// `consistent` has the paper's curves with one damage variable, an energy, and a dissipation that is never negative. Of the
// cohesion of a point the share β is left (1 at first), and a share a carries friction (0 at first):
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
// damage here: un- and reloading go along the secant before the peak too. δso = e tc/ks: an open contact has the strength tc in
// shear as well, the text's σ of Eq 7. λu gives every direction of opening the energy Gf. A point that failed closed carries
// friction on all of its area, from the traction it had (Eq 12); one that failed open on the share D it has lost, from zero when
// it closes. Shares are merged by their mean slip; energy is convex in slip, so what is lost thereby is never negative. Over
// δn = 0 only β can change, and only fall: that costs energy and never makes any, so there is no mismatch. Coupling is full by
// nature.
//
// Energy. `stored_energy` is a function of state. Dissipation is booked where the law says it happens: growth of δmax and
// the fall from a peak (fracture), slip against friction (friction). Where a reading has no potential, the difference is
// booked as mismatch: at δn = 0 the stored energies of the two branches (literal, scaled), on all open paths before damage
// the part of the traction that is no gradient (continuous).
//
// Valid for |δ| small against the contact's length.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string_view>

#include "share/material.hpp"
#include "share/run_file.hpp"
#include "solver/exponential.hpp"

namespace graincrack {

/// Readings of the law (--contact-law).
enum class LawVariant : std::uint8_t { literal, scaled, continuous, consistent };
/// What failure in one mode does to the other (--coupling).
enum class Coupling : std::uint8_t { full, none };

/// Constants of a law, derived once. \see make_contact_law
struct ContactLaw {
    LawVariant variant;
    Coupling coupling;
    double kt, ks;  ///< Pa/m
    double tc;      ///< Pa
    double tan_phi;
    double dct, dcs, dut;  ///< δct, δcs, δut, m
    double w;              ///< weight of δs² in δeff² of the open branch: 1 (literal), κ (scaled, continuous)
    double inv_dct, inv_dcs;
    double inv_dso;  ///< 1/δso, δso = e tc/ks (consistent)
    double gf;       ///< Gf, J/m²
};
inline ContactLaw make_contact_law(const ContactParameters& p, LawVariant variant, Coupling coupling) {
    return {variant,
            coupling,
            p.normal_stiffness,
            p.shear_stiffness,
            p.tensile_strength,
            std::tan(p.friction_angle),
            p.critical_opening,
            p.critical_sliding,
            p.ultimate_opening,
            variant == LawVariant::literal ? 1.0 : p.shear_stiffness / p.normal_stiffness,
            1 / p.critical_opening,
            1 / p.critical_sliding,
            p.shear_stiffness / (std::numbers::e * p.tensile_strength),
            p.fracture_energy};
}

struct ContactMotion {
    double opening = 0;  ///< δn, m
    double sliding = 0;  ///< δs, m
};
struct ContactTraction {
    double normal = 0;  ///< σn, Pa
    double shear = 0;   ///< τ, Pa
};

/// What a contact point remembers.
struct ContactHistory {
    ContactMotion motion;                       ///< of the last update
    double max_displacement = 0;                ///< δmax once failed open, m
    double peak_displacement = 0;               ///< δpk (continuous), m
    double slip = 0;                            ///< frictional slip: τ = ks (δs − slip), m
    double cohesion_left = 1;                   ///< β (consistent)
    double friction_share = 0;                  ///< a (consistent)
    bool failed_open = false;                   ///< passed the peak of the open branch
    bool failed_closed = false;                 ///< passed the peak of the closed branch
    bool separated = false;                     ///< past δut, or open after a failure that left nothing
    CrackMode first_mode = CrackMode::tensile;  ///< of the first failure

    [[nodiscard]] bool failed() const { return failed_open || failed_closed; }
};
/// The history of a contact that starts broken (pre-existing crack).
inline ContactHistory broken_contact() {
    ContactHistory h;
    h.failed_open = h.failed_closed = h.separated = true;
    h.max_displacement = std::numeric_limits<double>::max();  // nothing is left of either branch
    h.cohesion_left = 0;
    h.friction_share = 1;
    return h;
}

/// Energies per area booked in one update, J/m².
struct ContactDissipation {
    double fracture = 0;
    double friction = 0;
    double mismatch = 0;
};
struct ContactResponse {
    ContactTraction traction;
    ContactHistory history;
    ContactDissipation dissipation;
};

namespace contact_law {

/// True if the closed contact carries friction only.
inline bool is_frictional(const ContactLaw& law, const ContactHistory& h) {
    return h.failed_closed || (law.coupling == Coupling::full && h.failed_open);
}
/// True if the open contact carries nothing because of how it failed closed.
inline bool is_lost_open(const ContactLaw& law, const ContactHistory& h) {
    return law.coupling == Coupling::full && h.failed_closed;
}

/// [1 − (1 + x) e^(−x)] / x²: stored energy of the exponential branch over (stiffness · displacement²).
inline double exponential_energy(double x, double exp_minus_x) {
    if (x < 0.02) {  // series; the next term, x⁴/144, is below 1.2e-9 of the first
        return 0.5 - x * (1.0 / 3.0 - x * (1.0 / 8.0 - x * (1.0 / 30.0)));
    }
    return (1 - (1 + x) * exp_minus_x) / (x * x);
}

// --- open branch of literal and scaled -------------------------------------------------------------------------------

inline double effective_displacement(const ContactLaw& law, const ContactMotion& m) {
    return std::sqrt(m.opening * m.opening + law.w * m.sliding * m.sliding);
}
/// Secant stiffness at δmax: tc (1 − D)/δmax, Eqs 7, 9.
inline double reduced_stiffness(const ContactLaw& law, double max_displacement) {
    return max_displacement >= law.dut ? 0 : law.tc * (law.dut - max_displacement) / ((law.dut - law.dct) * max_displacement);
}
/// Dissipated on the way to δmax ≥ δct: the area under the curve less the recoverable triangle, J/m².
inline double softening_dissipation(const ContactLaw& law, double max_displacement) {
    const double m = std::min(max_displacement, law.dut);
    const double past = m - law.dct;
    const double range = law.dut - law.dct;
    const double area = law.tc * law.dct * (std::numbers::e - 2) + (range > 0 ? law.tc * (past - past * past / (2 * range)) : 0);
    return area - 0.5 * reduced_stiffness(law, m) * m * m;
}

// --- open branch of continuous ---------------------------------------------------------------------------------------

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
/// Damage of the continuous reading.
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
inline double continuous_mismatch(const ContactLaw& law, const ContactMotion& from, const ContactMotion& to) {
    const ContactMotion mid{0.5 * (from.opening + to.opening), 0.5 * (from.sliding + to.sliding)};
    const double l2 = lambda_squared(law, mid);
    if (l2 == 0) {
        return 0;
    }
    const double lambda = std::sqrt(l2);
    const double e = exp_of_minus(lambda);
    const double ratio = quadratic_form(law, mid) / l2;
    const double dn = to.opening - from.opening;
    const double ds = to.sliding - from.sliding;
    const double gradient = 2 * ((law.kt - ratio * law.inv_dct * law.inv_dct) * mid.opening * dn +
                                 (law.ks - ratio * law.inv_dcs * law.inv_dcs) * mid.sliding * ds);
    return (0.5 * e - exponential_energy(lambda, e)) * gradient;
}

// --- consistent ------------------------------------------------------------------------------------------------------

inline double consistent_energy(const ContactLaw& law, const ContactHistory& h) {
    const ContactMotion& m = h.motion;
    const double shear = law.ks * m.sliding * m.sliding;
    if (m.opening >= 0) {
        return 0.5 * h.cohesion_left * (law.kt * m.opening * m.opening + shear);
    }
    const double elastic = m.sliding - h.slip;
    return 0.5 * (law.kt * m.opening * m.opening + h.cohesion_left * shear + h.friction_share * law.ks * elastic * elastic);
}
/// D of the open branch at a load λ ≥ 1 in a direction in which q = kt δn² + ks δs² is `stiffness` λ².
inline double consistent_damage(const ContactLaw& law, double load, double stiffness) {
    constexpr double e = std::numbers::e;
    // Work along a straight path: `stiffness` · [(1 − 2/e) + (λu − 1)/(2 e)] = Gf.
    const double range = 2 * e * (law.gf / stiffness - (1 - 2 / e));
    return range > load - 1 ? (load - 1) / range : 1.0;
}

}  // namespace contact_law

/// Recoverable energy per area of a contact point in its present motion, J/m².
inline double stored_energy(const ContactLaw& law, const ContactHistory& h) {
    using namespace contact_law;
    const ContactMotion& m = h.motion;
    if (law.variant == LawVariant::consistent) {
        return consistent_energy(law, h);
    }
    if (m.opening < 0) {
        const double normal = 0.5 * law.kt * m.opening * m.opening;
        if (is_frictional(law, h)) {
            const double elastic = m.sliding - h.slip;
            return normal + 0.5 * law.ks * elastic * elastic;
        }
        const double y = std::abs(m.sliding) * law.inv_dcs;
        return normal + law.ks * m.sliding * m.sliding * exponential_energy(y, exp_of_minus(y));
    }
    if (is_lost_open(law, h)) {
        return 0;
    }
    if (law.variant == LawVariant::continuous) {
        if (h.failed_open) {
            return 0.5 * continuous_reduction(law, h) * quadratic_form(law, m);
        }
        const double lambda = std::sqrt(lambda_squared(law, m));
        return quadratic_form(law, m) * exponential_energy(lambda, exp_of_minus(lambda));
    }
    const double d = effective_displacement(law, m);
    if (h.failed_open) {
        return 0.5 * reduced_stiffness(law, h.max_displacement) * d * d;
    }
    const double x = d * law.inv_dct;
    return law.kt * d * d * exponential_energy(x, exp_of_minus(x));
}

/// Damage D of a contact point, 0 to 1 (Eq 9).
inline double damage(const ContactLaw& law, const ContactHistory& h) {
    if (h.separated || contact_law::is_lost_open(law, h)) {
        return 1;
    }
    if (law.variant == LawVariant::consistent) {
        return h.friction_share;
    }
    if (!h.failed_open) {
        return 0;
    }
    if (law.variant == LawVariant::continuous) {
        return contact_law::continuous_damage(law, h.max_displacement, h.peak_displacement);
    }
    return law.dut > law.dct ? std::min(1.0, (h.max_displacement - law.dct) / (law.dut - law.dct)) : 1.0;
}

/// State of a contact point as the files name it.
inline PointState point_state(const ContactHistory& h) {
    if (!h.failed()) {
        return PointState::intact;
    }
    if (h.separated) {
        return PointState::separated;
    }
    return h.first_mode == CrackMode::tensile ? PointState::failed_tension : PointState::failed_shear;
}

namespace contact_law {

inline void mark_failed(ContactHistory& h, CrackMode mode) {
    if (!h.failed()) {
        h.first_mode = mode;
    }
    (mode == CrackMode::tensile ? h.failed_open : h.failed_closed) = true;
}

/// Friction of a failed, closed contact, Eq 12 by signed increments.
inline void slide(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    const double limit = -law.kt * to.opening * law.tan_phi;
    const double old_shear = law.ks * (r.history.motion.sliding - r.history.slip);
    const double trial = law.ks * (to.sliding - r.history.slip);
    r.traction.shear = std::clamp(trial, -limit, limit);
    const double slip = to.sliding - r.traction.shear / law.ks;
    if (trial != r.traction.shear) {
        r.dissipation.friction += 0.5 * (old_shear + r.traction.shear) * (slip - r.history.slip);
        r.history.slip = slip;
    }
}

/// Advances an open contact of the consistent reading to an open motion.
inline void advance_open_consistent(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
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
    const double before = h.cohesion_left;
    h.cohesion_left = std::min(before, left);
    // The motion before is open too, so both values of q are those of ψ; the change of β is booked at their mean.
    const double q_before = law.kt * h.motion.opening * h.motion.opening + law.ks * h.motion.sliding * h.motion.sliding;
    r.dissipation.fracture += 0.25 * (q_before + q) * (before - h.cohesion_left);
    h.separated = h.separated || h.cohesion_left == 0;
    r.traction = {h.cohesion_left * law.kt * to.opening, h.cohesion_left * law.ks * to.sliding};
    h.motion = to;
}

/// Advances a closed contact of the consistent reading to a closed motion.
inline void advance_closed_consistent(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    ContactHistory& h = r.history;
    const ContactMotion from = h.motion;
    const double limit = -law.kt * to.opening * law.tan_phi;
    const double load = std::abs(to.sliding) * law.inv_dcs;
    ContactResponse friction{{}, h, {}};
    slide(law, to, friction);
    h.slip = friction.history.slip;
    r.dissipation.friction += h.friction_share * friction.dissipation.friction;
    double frictional_shear = friction.traction.shear;
    if (load <= 1) {
        const double before = h.cohesion_left;
        h.cohesion_left = std::min(before, exp_of_minus(load));
        r.dissipation.fracture +=
            0.25 * law.ks * (from.sliding * from.sliding + to.sliding * to.sliding) * (before - h.cohesion_left);
    } else if (h.cohesion_left > 0) {
        // The peak is passed: the cohesive share goes on with friction, from the traction it had.
        const double share = 1 - h.friction_share;
        const double carried = std::clamp(h.cohesion_left * law.ks * to.sliding / share, -limit, limit);
        const double stored =
            h.cohesion_left * law.ks * to.sliding * to.sliding + h.friction_share * frictional_shear * frictional_shear / law.ks;
        h.slip = h.friction_share * h.slip + share * (to.sliding - carried / law.ks);
        frictional_shear = law.ks * (to.sliding - h.slip);
        h.cohesion_left = 0;
        h.friction_share = 1;
        mark_failed(h, CrackMode::shear);
        r.dissipation.fracture += 0.5 * (stored - frictional_shear * frictional_shear / law.ks);
    }
    r.traction = {law.kt * to.opening, h.cohesion_left * law.ks * to.sliding + h.friction_share * frictional_shear};
    h.motion = to;
}

/// Advances a closed contact to a closed motion.
inline void advance_closed(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    if (law.variant == LawVariant::consistent) {
        advance_closed_consistent(law, to, r);
        return;
    }
    r.traction.normal = law.kt * to.opening;
    if (is_frictional(law, r.history)) {
        slide(law, to, r);
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
    const double limit = -law.kt * to.opening * law.tan_phi;
    r.traction.shear = std::clamp(old_shear + law.ks * (to.sliding - r.history.motion.sliding), -limit, limit);
    r.history.slip = to.sliding - r.traction.shear / law.ks;
    mark_failed(r.history, CrackMode::shear);
    r.dissipation.fracture +=
        law.ks * to.sliding * to.sliding * exponential_energy(y, e) - 0.5 * r.traction.shear * r.traction.shear / law.ks;
    r.history.motion = to;
}

/// Advances an open contact of the literal or scaled reading to an open motion.
inline void advance_open_effective(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    ContactHistory& h = r.history;
    const double d = effective_displacement(law, to);
    double stiffness = 0;
    if (!h.failed_open && d <= law.dct) {
        stiffness = law.kt * exp_of_minus(d * law.inv_dct);
    } else {
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
        stiffness = reduced_stiffness(law, h.max_displacement);
    }
    r.traction = {stiffness * to.opening, stiffness * law.w * to.sliding};
    h.motion = to;
}

/// Advances an open contact of the continuous reading to an open motion.
inline void advance_open_continuous(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    ContactHistory& h = r.history;
    const double l2 = lambda_squared(law, to);
    const double q = quadratic_form(law, to);
    double reduction = 0;
    if (!h.failed_open) {
        r.dissipation.mismatch += continuous_mismatch(law, h.motion, to);
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
    h.motion = to;
}

inline void advance_open(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    if (law.variant == LawVariant::consistent) {
        advance_open_consistent(law, to, r);
    } else if (is_lost_open(law, r.history)) {
        r.history.separated = true;
        r.traction = {};
        r.history.motion = to;
    } else if (law.variant == LawVariant::continuous) {
        advance_open_continuous(law, to, r);
    } else {
        advance_open_effective(law, to, r);
    }
}

/// Takes a contact over δn = 0, where the branches meet: what their stored energies differ by is mismatch.
inline void cross(const ContactLaw& law, bool opens, double sliding, ContactResponse& r) {
    const double before = stored_energy(law, r.history);
    const double fracture = r.dissipation.fracture;
    const ContactMotion edge{0, sliding};
    if (opens) {
        advance_open(law, edge, r);
    } else {
        r.history.motion = edge;
        if (is_frictional(law, r.history) || law.variant == LawVariant::consistent) {
            r.history.slip = sliding;  // no normal traction yet, so no friction
        }
    }
    // Stored energy of the closed branch at δn → 0−: a zero opening counts as open, so approach it from below.
    ContactHistory after = r.history;
    after.motion.opening = opens ? 0.0 : -std::numeric_limits<double>::denorm_min();
    r.dissipation.mismatch += before - stored_energy(law, after) - (r.dissipation.fracture - fracture);
    r.history.motion.opening = after.motion.opening;
}

}  // namespace contact_law

/// The law: motion and old history in; traction, new history and what was dissipated out.
///
/// \param to the new motion of the contact point, m
/// \param history what it remembers; `history.motion` is the motion before
inline ContactResponse update_contact(const ContactLaw& law, const ContactMotion& to, const ContactHistory& history) {
    ContactResponse r{{}, history, {}};
    const bool was_open = history.motion.opening >= 0;
    const bool is_open = to.opening >= 0;
    if (was_open != is_open) {
        const double share = history.motion.opening / (history.motion.opening - to.opening);
        const double sliding = history.motion.sliding + share * (to.sliding - history.motion.sliding);
        // First along the old branch to the edge, then over it.
        const ContactMotion edge{was_open ? 0.0 : -std::numeric_limits<double>::denorm_min(), sliding};
        was_open ? contact_law::advance_open(law, edge, r) : contact_law::advance_closed(law, edge, r);
        contact_law::cross(law, is_open, sliding, r);
    }
    is_open ? contact_law::advance_open(law, to, r) : contact_law::advance_closed(law, to, r);
    return r;
}

// --- the same law for intact points, without a branch, for vector units -----------------------------------------------------

/// Constants of the intact law: one formula for all readings.
struct IntactLaw {
    double kt, ks, open_ks;          ///< normal stiffness; shear stiffness closed and open
    double open_normal, open_shear;  ///< weights of δn², δs² in the squared load of the open branch
    double closed_shear;             ///< weight of δs² in that of the closed branch
    double follows_open;             ///< 0 if open points need `update_contact` (they book mismatch or damage), else 1
    double follows_closed;           ///< likewise
};
inline IntactLaw make_intact_law(const ContactLaw& law) {
    const bool continuous = law.variant == LawVariant::continuous;
    const bool consistent = law.variant == LawVariant::consistent;
    return {law.kt,
            law.ks,
            continuous ? law.ks : law.w * law.kt,
            law.inv_dct * law.inv_dct,
            continuous ? law.inv_dcs * law.inv_dcs : law.w * law.inv_dct * law.inv_dct,
            law.inv_dcs * law.inv_dcs,
            continuous || consistent ? 0.0 : 1.0,
            consistent ? 0.0 : 1.0};
}
struct IntactTraction {
    double normal, shear;  ///< Pa
    double load;           ///< δeff/δct, λ or |δs|/δcs: 1 at the peak
};
/// What `update_contact` gives while the point stays on its branch and `load` ≤ 1.
inline IntactTraction intact_traction(const IntactLaw& law, double opening, double sliding) {
    const bool open = opening >= 0;
    const double squared =
        (open ? law.open_normal : 0.0) * opening * opening + (open ? law.open_shear : law.closed_shear) * sliding * sliding;
    const double load = std::sqrt(squared);
    const double decay = exp_of_minus(load);
    return {law.kt * (open ? decay : 1.0) * opening, (open ? law.open_ks : law.ks) * decay * sliding, load};
}

/// Name of a reading as options and files spell it.
constexpr std::string_view name_of(LawVariant variant) {
    switch (variant) {
        case LawVariant::literal: return "literal";
        case LawVariant::scaled: return "scaled";
        case LawVariant::continuous: return "continuous";
        case LawVariant::consistent: return "consistent";
    }
    return "?";
}
constexpr std::string_view name_of(Coupling coupling) { return coupling == Coupling::full ? "full" : "none"; }

}  // namespace graincrack
