// `coulomb-slip` (share/doc/laws.md): the Coulomb slip model of joints with residual strength of UDEC (Itasca), without dilation.
//
//   σn = kt δn,  τ = ks (δs − slip)             linear, the same on both sides of δn = 0; a shut joint has a
//                                               stiffer σn (joint.hpp)
//   fails if  σn > T  or  |τ| > c − σn tan φ    the Coulomb line continues into tension until it reaches zero
//
// A failed point has the residual values T_r, c_r and φ_r. A point pulled above T_r separates: it then carries nothing while
// open, and compression and friction while closed.
//
// The stored energy is ½ kt δn² + ½ ks (δs − slip)², or 0 while open and separated. The fall from the peak is fracture energy;
// slip dissipates friction, and so does the shear that c_r carried when a point separates.
#pragma once

#include <cmath>

#include "solver/law/joint.hpp"
#include "solver/law/vector_path.hpp"

namespace graincrack::contact_law {

struct CoulombSlip {
    static constexpr LawDescription description{
        .variant = LawVariant::coulomb_slip,
        .name = "coulomb-slip",
        .meaning = "UDEC's Coulomb slip with residual strength",
        .potential = true,
        .parameters = {&ContactParameters::residual_tensile_strength, &ContactParameters::residual_cohesion,
                       &ContactParameters::residual_friction_angle, &ContactParameters::maximum_closure,
                       &ContactParameters::shut_stiffness, &ContactParameters::wear_slip}};
    static constexpr bool damages_intact = false;
    static FractureEnergies min_energies(const ContactLaw& /*law*/) { return {}; }
    static void complete(ContactLaw& law) { law.stiffest_shear = law.ks; }

    /// Shear strength at a normal traction, Pa.
    static double shear_limit(double cohesion, double tan_phi, double normal) {
        return std::max(0.0, cohesion - normal * tan_phi);
    }

    /// Advances a point on either branch. Until it separates it behaves the same on both sides of δn = 0.
    static void advance(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        if (is_residual(law, h)) {
            advance_residual(law, to, r);
            return;
        }
        if (!h.failed()) {
            if (advance_intact<CoulombSlip>(law, to, r)) return;
            fail(law, to, r);
        }
        const bool open = to.opening >= 0;
        const double normal = joint_traction(law, to.opening);
        if (open && !h.separated && normal > law.residual_tc) {
            h.separated = true;
            r.dissipation.fracture += 0.5 * law.residual_tc * law.residual_tc / law.kt;
        }
        const bool bears = !open || !h.separated;
        r.traction.normal = bears ? normal : 0.0;
        slide(law, to, bears ? shear_limit(law.residual_cc, law.residual_tan_phi, normal) : 0.0, r);
        h.motion = to;
    }
    /// Closes a point. The shear spring of a separated point starts from zero; that of any other point continues.
    static void close(const ContactLaw& /*law*/, ContactResponse& r) {
        if (r.history.separated) r.history.slip = r.history.motion.sliding;
    }

    static double stored_energy(const ContactLaw& law, const ContactHistory& h) {
        if (h.separated && h.motion.opening >= 0) return 0;
        const double elastic = h.motion.sliding - h.slip;
        return joint_energy(law, h.motion.opening) + 0.5 * law.ks * elastic * elastic;
    }
    static double damage(const ContactLaw& /*law*/, const ContactHistory& h) { return h.failed() ? 1 : 0; }
    /// False with a residual cohesion, whose shear an opening point relaxes, and for joints that can shut: it has neither.
    static bool is_residual(const ContactLaw& law, const ContactHistory& h) {
        return h.separated && law.residual_cc == 0 && std::isinf(law.maximum_closure);
    }
    static IntactResponse intact(const ContactLaw& law, const MovedPoint& p) {
        const double normal = joint_traction(law, p.opening);
        const double shear = law.ks * p.sliding;
        const bool holds = normal <= law.tc && std::abs(shear) <= shear_limit(law.cc, law.tan_phi, normal);
        return {normal, shear, holds ? 1.0 : 0.0};
    }

private:
    /// Moves a point from the elastic state at `to` to the residual state; the energy that the springs lose is fracture energy.
    static void fail(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
        ContactHistory& h = r.history;
        const double normal = joint_traction(law, to.opening);
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
        h.motion.sliding = to.sliding;  // `slide` starts from here
    }
};

}  // namespace graincrack::contact_law
