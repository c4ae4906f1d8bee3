// The types of the contact laws: constants, motion and traction of a contact point, its history, the response to a motion.
//
// Signs: opening δn > 0 and tension σn > 0; sliding δs and shear traction τ are signed.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include "share/rock/contact_parameters.hpp"
#include "share/rock/contact_state.hpp"

namespace graincrack {

/// The contact laws (--contact-law); the order is that of `all_contact_laws`.
enum class LawVariant : std::uint8_t { literal, consistent, coulomb_slip, combined, cohesive_frictional };
/// The law of a material that names none.
inline constexpr LawVariant default_law = LawVariant::consistent;

/// Fracture energies, J/m².
struct FractureEnergies {
    double opening = 0;  ///< Gf, G_I
    double sliding = 0;  ///< G_II
};

/// A row of the table of laws.
struct LawDescription {
    LawVariant variant;
    std::string_view name;                  ///< as options and files spell it
    std::string_view meaning;               ///< in a few words
    bool potential = false;                 ///< its tractions derive from an energy, so that no path does non-conservative work
    bool friction_beside_cohesion = false;  ///< friction adds to the remaining cohesion: under pressure a point past the
                                            ///< peak of its cohesion has not lost its strength
    std::array<ContactValue, 7> parameters{};  ///< contact parameters it reads beside those that every law reads

    /// The event by which micro-cracks are counted.
    [[nodiscard]] constexpr CrackEvent crack_event() const {
        return friction_beside_cohesion ? CrackEvent::half_damaged : CrackEvent::failed;
    }
    [[nodiscard]] constexpr bool reads(ContactValue parameter) const {
        return std::find(parameters.begin(), parameters.end(), parameter) != parameters.end();
    }
};

/// Constants of a law, with the symbols of Kazerani & Zhao 2014. \see make_contact_law
struct ContactLaw {
    LawVariant variant;
    double kt, ks;   ///< initial stiffnesses (Eqs 3–5), Pa/m
    double tc, cc;   ///< tensile strength, cohesion, Pa
    double tan_phi;  ///< of the friction angle φc
    double gf, g2;   ///< Gf or G_I, and G_II, J/m²
    double residual_tc, residual_cc, residual_tan_phi;
    double worn_tan_phi, wear_slip;  ///< of node–edge contacts: tan φr, and w, m; without wear tan φr is `residual_tan_phi` too
    double dct, dcs, dut;            ///< δct, δcs, δut (Eqs 8, 11, 14), m
    double inv_dct, inv_dcs;         ///< 1/m
    double maximum_closure;          ///< of a joint (coulomb-slip), m; infinite where it is never shut
    double stiffest_normal;          ///< stiffness of a joint that is shut, otherwise kt, Pa/m
    double stiffest_shear;           ///< largest shear stiffness a point can reach, for the stable time step, Pa/m
    double open_shear_strength;      ///< to (consistent, cohesive-frictional), Pa
    double inv_dso;                  ///< 1/δso, δso = e to/ks (likewise)
    double op, sp;                   ///< o_p, s_p: displacements at the peaks (combined), m
    double inv_op, inv_sp;           ///< 1/m
    double o_range, s_range;  ///< (o_r − o_p)/o_p, (s_r − s_p)/s_p (combined); s = λu − 1 while closed (cohesive-frictional)
    bool softens_in_shear;    ///< a closed point loses its cohesion over a distance, beside friction
    double bridge;            ///< ρ = σb/tc, 0 without bridges (consistent, cohesive-frictional)
    double bridge_decay;      ///< ρ²/(2 e Gb) (likewise), m²/J
};

struct ContactMotion {
    double opening = 0;  ///< δn, m
    double sliding = 0;  ///< δs, m
    friend bool operator==(const ContactMotion&, const ContactMotion&) = default;
};
struct ContactTraction {
    double normal = 0;  ///< σn, Pa
    double shear = 0;   ///< τ, Pa
};

/// The history of a contact point: its last motion and all values on which the next response depends.
struct ContactHistory {
    ContactMotion motion;                       ///< of the last update
    double max_displacement = 0;                ///< δmax once failed open (literal), m
    double largest_open = 0;                    ///< largest δn/o_p once past 1, else 0 (combined)
    double largest_slid = 0;                    ///< largest |δs|/s_p once past 1, else 0 (combined)
    double slip = 0;                            ///< frictional slip: τ = ks (δs − slip), m
    double integrity = 1;                       ///< β (consistent, cohesive-frictional)
    double friction_fraction = 0;               ///< a (consistent, cohesive-frictional)
    double bridge = 0;                          ///< b, the integrity of its bridge (likewise)
    bool failed_open = false;                   ///< passed the peak of the open branch
    bool failed_closed = false;                 ///< passed the peak of the closed branch
    bool separated = false;                     ///< past δut, or open after a failure without residual strength
    CrackMode first_mode = CrackMode::tensile;  ///< of the first failure

    [[nodiscard]] bool failed() const { return failed_open || failed_closed; }
    friend bool operator==(const ContactHistory&, const ContactHistory&) = default;
};

/// Energies per area dissipated in one update, J/m².
struct ContactDissipation {
    double fracture = 0;
    double friction = 0;
    double non_conservative_work = 0;  ///< lost (positive) or gained (negative) where the law has no potential
};
/// The response of an update to a motion.
struct ContactResponse {
    ContactTraction traction;
    ContactHistory history;
    ContactDissipation dissipation;
};

/// The history of a contact that starts broken (pre-existing crack).
inline ContactHistory broken_contact() {
    ContactHistory h;
    h.failed_open = h.failed_closed = h.separated = true;
    h.max_displacement = h.largest_open = h.largest_slid = std::numeric_limits<double>::max();  // no strength is left
    h.integrity = 0;
    h.friction_fraction = 1;
    return h;
}

/// State of a contact point by its name in files.
inline PointState point_state(const ContactHistory& h) {
    if (!h.failed()) return PointState::intact;
    if (h.separated) return PointState::separated;
    return h.first_mode == CrackMode::tensile ? PointState::failed_tension : PointState::failed_shear;
}

/// Damage levels: fractions of the cohesion that remain when a point is damaged by 10, 50 and 90 %. A point below the last one is
/// broken. The first two are of the brittle part without the bridge.
inline constexpr std::array<double, 3> damage_levels{0.9, 0.5, 0.1};
/// The next damage level of a point that has passed so many of them; 0 after the last one, as no point falls below it.
constexpr double damage_level(std::size_t passed) { return passed < damage_levels.size() ? damage_levels[passed] : 0; }
/// Number of damage levels above the remaining cohesion of a point.
constexpr std::size_t count_levels_above(double remaining) {
    std::size_t count = 0;
    while (remaining < damage_level(count)) ++count;
    return count;
}

namespace contact_law {

/// Records that a point has passed its peak in a mode.
inline void mark_failed(ContactHistory& h, CrackMode mode) {
    if (!h.failed()) h.first_mode = mode;
    (mode == CrackMode::tensile ? h.failed_open : h.failed_closed) = true;
}

}  // namespace contact_law
}  // namespace graincrack
