// The contact laws: pure functions of motion and history. `update_contact` is the law; each law has a file in solver/law.
//
// Most are variants of the cohesive law of Kazerani & Zhao (2014), §3.1. Symbols as in the paper:
//
//   kt, ks   initial stiffnesses (Eqs 3–5)        δct = e tc/kt, δcs = e cc/ks   critical displacements (Eqs 8, 11)
//   tc, cc   tensile strength, cohesion           δut                           ultimate displacement (Eq 14)
//   φc       friction angle of a failed contact   κ = ks/kt
//
// Every law has an open branch (δn ≥ 0) and a closed one (δn < 0). An update that changes sides moves to δn = 0 on the one,
// crosses to the other, and moves away from δn = 0 on that.
//
// Energy. `stored_energy` is a function of state. Damage and the fall from a peak are fracture, slip is friction, each by its own
// formula. Where a law has no potential, the rest of the work done on a point is booked as non-conservative work.
//
// Strength factor. A contact whose strengths are s times those of its class, its fracture energies s² times and its stiffnesses
// the same, has a similar law, with the same length E G/t² of the process zone:
//
//   σ_s(δ) = s σ_1(δ/s),  ψ_s(δ) = s² ψ_1(δ/s)
//
// So its points are advanced with the constants of the class at motions over s, and `State` keeps motions and slips over s.
//
// Valid for |δ| small against the contact's length.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "share/rock/material.hpp"
#include "solver/law/table.hpp"

namespace graincrack {

inline ContactLaw make_contact_law(const ContactParameters& p, LawVariant variant) {
    ContactLaw law{};
    law.variant = variant;
    law.kt = p.normal_stiffness;
    law.ks = p.shear_stiffness;
    law.tc = p.tensile_strength;
    law.cc = p.cohesion;
    law.tan_phi = std::tan(p.friction_angle);
    law.gf = p.fracture_energy;
    law.g2 = p.mode_ii_fracture_energy;
    law.open_shear_strength = p.open_shear_strength;
    const LawDescription& description = description_of(variant);
    law.residual_tc = description.reads(&ContactParameters::residual_tensile_strength) ? p.residual_tensile_strength : 0;
    law.residual_cc = description.reads(&ContactParameters::residual_cohesion) ? p.residual_cohesion : 0;
    law.worn_tan_phi =
        description.reads(&ContactParameters::residual_friction_angle) ? std::tan(p.residual_friction_angle) : law.tan_phi;
    law.wear_slip = description.reads(&ContactParameters::wear_slip) ? p.wear_slip : 0;
    law.residual_tan_phi = law.wear_slip > 0 ? law.tan_phi : law.worn_tan_phi;  // faces that have yet to slide are fresh
    law.dct = p.critical_opening;
    law.dcs = p.critical_sliding;
    law.dut = p.ultimate_opening;
    law.inv_dct = 1 / law.dct;
    law.inv_dcs = 1 / law.dcs;
    const bool shuts = description.reads(&ContactParameters::maximum_closure) && p.maximum_closure > 0;
    law.maximum_closure = shuts ? p.maximum_closure : std::numeric_limits<double>::infinity();
    law.stiffest_normal = shuts ? std::max(law.kt, p.shut_stiffness) : law.kt;
    const bool is_bridged =
        description.reads(&ContactParameters::bridging_strength) && p.bridging_strength > 0 && p.bridging_energy > 0;
    law.bridge = is_bridged ? p.bridging_strength / law.tc : 0;
    law.bridge_decay = is_bridged ? law.bridge * law.bridge / (2 * std::numbers::e * p.bridging_energy) : 0;
    contact_law::with_law(variant, [&law](auto kind) { decltype(kind)::complete(law); });
    return law;
}

/// The law of each class of contacts: one variant, with constants of their own.
struct ContactLaws {
    std::vector<ContactLaw> of_class;
    ContactLaws() = default;
    /// One class. (Implicit: a single law stands for the laws of a specimen of one phase.)
    ContactLaws(const ContactLaw& law) : of_class{law} {}  // NOLINT(google-explicit-constructor)
    [[nodiscard]] const ContactLaw& operator[](std::int32_t contact_class) const { return of_class[contact_class]; }
    [[nodiscard]] LawVariant variant() const { return of_class.front().variant; }
    /// Whether the faces of a class wear.
    [[nodiscard]] bool wear() const {
        return std::any_of(of_class.begin(), of_class.end(), [](const ContactLaw& law) { return law.wear_slip > 0; });
    }
};
/// \param contacts parameters by class
inline ContactLaws make_contact_laws(const std::vector<ContactParameters>& contacts, LawVariant variant) {
    ContactLaws laws;
    for (const ContactParameters& contact : contacts) laws.of_class.push_back(make_contact_law(contact, variant));
    return laws;
}

/// The least fracture energies with which a law works: the energies up to its peaks.
inline FractureEnergies min_fracture_energies(const ContactLaw& law) {
    return contact_law::with_law(law.variant, [&](auto kind) { return decltype(kind)::min_energies(law); });
}

namespace contact_law {

/// Takes a contact point over δn = 0, where the branches meet. The difference of their stored energies is non-conservative work.
template <class Law>
void cross(const ContactLaw& law, bool opens, ContactResponse& r) {
    const double before = Law::stored_energy(law, r.history);
    const double booked = r.dissipation.fracture + r.dissipation.friction;
    const ContactMotion edge{0, r.history.motion.sliding};
    r.history.motion = edge;
    if (opens) {
        Law::advance(law, edge, r);
    } else {
        Law::close(law, r);
        r.history.motion.opening = -std::numeric_limits<double>::denorm_min();  // the closed branch at δn → 0−
    }
    const double released = before - Law::stored_energy(law, r.history);
    r.dissipation.non_conservative_work += released - (r.dissipation.fracture + r.dissipation.friction - booked);
}

/// Moves the point with the history `r.history`; adds to `r.dissipation`.
template <class Law>
void move_point(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    const ContactMotion from = r.history.motion;
    const bool was_open = from.opening >= 0;
    const bool is_open = to.opening >= 0;
    if (was_open != is_open) {
        const double fraction = from.opening / (from.opening - to.opening);
        const double sliding = from.sliding + fraction * (to.sliding - from.sliding);
        Law::advance(law, {was_open ? 0.0 : -std::numeric_limits<double>::denorm_min(), sliding}, r);
        cross<Law>(law, is_open, r);
    }
    Law::advance(law, to, r);
}

template <class Law>
ContactResponse update(const ContactLaw& law, const ContactMotion& to, const ContactHistory& history) {
    ContactResponse r{{}, history, {}};
    move_point<Law>(law, to, r);
    return r;
}

template <class Law>
double damage(const ContactLaw& law, const ContactHistory& history) {
    return history.separated ? 1 : Law::damage(law, history);
}

/// Fraction of the peak of its cohesive traction that a contact point can still bear: 1 up to its failure. Below the last of
/// `damage_levels` the point is broken. Down to one half a bridge does not count.
template <class Law>
double remaining_cohesion(const ContactLaw& law, const ContactHistory& history) {
    if (!history.failed() || history.separated) return history.failed() ? 0 : 1;
    double cohesion = 0;
    if constexpr (requires { Law::remaining_cohesion(law, history); }) {
        cohesion = Law::remaining_cohesion(law, history);
    } else {
        cohesion = 1 - Law::damage(law, history);
    }
    if (history.bridge == 0) return cohesion;
    const Bridge bridge =
        advance_bridge(law, moved_point(history, history.motion), history.integrity, history.bridge, history.slip);
    return remaining_with_bridge(cohesion, bridge.remaining);
}

}  // namespace contact_law

/// The law: motion and old history in; traction, new history and dissipated energies out. It finds the law anew at every call:
/// what works on many points binds the law once, by `with_law`.
///
/// \param to the new motion of the contact point, m
/// \param history of the point; `history.motion` is the motion before
inline ContactResponse update_contact(const ContactLaw& law, const ContactMotion& to, const ContactHistory& history) {
    return contact_law::with_law(law.variant, [&](auto kind) { return contact_law::update<decltype(kind)>(law, to, history); });
}

}  // namespace graincrack
