// `coulomb-slip`: the Coulomb slip model of joints with residual strength, as UDEC has it (Itasca, UDEC, Constitutive models:
// "Coulomb slip with residual strength (area contact)"), without dilation.
//
//   σn = kt δn,  τ = ks (δs − slip)             linear, the same on both sides of δn = 0
//   fails if  σn > T  or  |τ| > c − σn tan φ    T, c, φ: tensile strength, cohesion, friction angle; the Coulomb line goes on
//                                               into tension, where it ends at zero
//
// A point that failed in either way has the residual values T_r, c_r, φ_r in place of T, c, φ, at once (displacement-weakening).
// Then |τ| ≤ c_r − σn tan φ_r by slip. If it is pulled above T_r, or failed above it, it separates: open it carries nothing, and
// never again; closed it pushes and slips as before. T_r = 0 unless given, so a failed point that opens has separated.
//
// Energy: ½ kt δn² + ½ ks (δs − slip)², nothing while open and separated. The fall from the peak is fracture, slip is friction:
// against what is left of the limit, which on opening is nothing, so that shear on c_r relaxes as friction. No mismatch.
#pragma once

#include <cmath>

#include "solver/law/friction.hpp"
#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

struct CoulombSlip {
    static constexpr LawDescription description{.variant = LawVariant::coulomb_slip,
                                                .name = "coulomb-slip",
                                                .meaning = "UDEC's Coulomb slip with residual strength",
                                                .potential = true,
                                                .residual_strength = true};
    static constexpr bool damages_intact = false;
    static FractureEnergies min_energies(const ContactLaw& /*law*/) { return {}; }
    static void complete(ContactLaw& law) { law.stiffest_shear = law.ks; }

    /// Shear strength at a normal traction, Pa.
    static double shear_limit(double cohesion, double tan_phi, double normal) {
        return std::max(0.0, cohesion - normal * tan_phi);
    }

    /// Both branches: the law does not know δn = 0 until it has separated.
    static void advance(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const bool open = to.opening >= 0;
        const double normal = law.kt * to.opening;
        const double shear = law.ks * (to.sliding - h.slip);
        if (!h.failed()) {
            if (normal <= law.tc && std::abs(shear) <= shear_limit(law.cc, law.tan_phi, normal)) {
                r.traction = {normal, shear};
                h.motion = to;
                return;
            }
            fail(law, to, r);
        }
        if (open && !h.separated && normal > law.residual_tc) {
            h.separated = true;
            r.dissipation.fracture += 0.5 * law.residual_tc * law.residual_tc / law.kt;
        }
        const bool bears = !open || !h.separated;
        r.traction.normal = bears ? normal : 0.0;
        slide(law, to, bears ? shear_limit(law.residual_cc, law.residual_tan_phi, normal) : 0.0, r);
        h.motion = to;
    }
    static void advance_open(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) { advance(law, to, r); }
    static void advance_closed(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) { advance(law, to, r); }
    static void close(const ContactLaw& /*law*/, ContactHistory& /*h*/) {}

    static double stored_energy(const ContactLaw& law, const ContactHistory& h) {
        if (h.separated && h.motion.opening >= 0) {
            return 0;
        }
        const double elastic = h.motion.sliding - h.slip;
        return 0.5 * (law.kt * h.motion.opening * h.motion.opening + law.ks * elastic * elastic);
    }
    static double damage(const ContactLaw& /*law*/, const ContactHistory& h) { return h.failed() ? 1 : 0; }
    static bool is_residual(const ContactLaw& /*law*/, const ContactHistory& /*h*/) { return false; }
    static IntactResponse intact(const ContactLaw& law, const IntactPoint& p) {
        const double normal = law.kt * p.opening;
        const double shear = law.ks * p.sliding;
        const bool holds = normal <= law.tc && std::abs(shear) <= shear_limit(law.cc, law.tan_phi, normal);
        return {normal, shear, holds ? 1.0 : 0.0};
    }

private:
    /// From the elastic state at `to` to the residual one: what the spring loses is fracture.
    static void fail(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double normal = law.kt * to.opening;
        const double shear = law.ks * to.sliding;
        mark_failed(h, to.opening >= 0 ? CrackMode::tensile : CrackMode::shear);
        double limit = shear_limit(law.residual_cc, law.residual_tan_phi, normal);
        if (normal > law.residual_tc) {
            h.separated = true;
            limit = 0;
            r.dissipation.fracture += 0.5 * normal * normal / law.kt;
        }
        const double left = std::clamp(shear, -limit, limit);
        r.dissipation.fracture += 0.5 * (shear * shear - left * left) / law.ks;
        h.slip = to.sliding - left / law.ks;
        h.motion.sliding = to.sliding;  // `slide` goes on from here
    }
};

}  // namespace graincrack::contact_law
