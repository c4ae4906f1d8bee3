// The constants of a contact law, derived once from the parameters of a contact.
#pragma once

#include "solver/law/types.hpp"

namespace graincrack {

/// Constants of a law. Symbols as in the paper. \see make_contact_law
struct ContactLaw {
    LawVariant variant;
    Coupling coupling;
    double kt, ks;   ///< initial stiffnesses (Eqs 3–5), Pa/m
    double tc, cc;   ///< tensile strength, cohesion, Pa
    double tan_phi;  ///< of the friction angle φc
    double gf, g2;   ///< Gf or G_I, and G_II, J/m²
    double residual_tc, residual_cc, residual_tan_phi;
    double dct, dcs, dut;        ///< δct, δcs, δut (Eqs 8, 11, 14), m
    double inv_dct, inv_dcs;     ///< 1/m
    double w;                    ///< weight of δs² in δeff² of the open branch: 1 (literal) or κ = ks/kt
    double stiffest_shear;       ///< largest shear stiffness a point can reach, for the stable time step, Pa/m
    double open_shear_strength;  ///< to (consistent), Pa
    double inv_dso;              ///< 1/δso, δso = e to/ks (consistent)
    double op, sp;               ///< o_p, s_p: displacements at the peaks (combined), m
    double inv_op, inv_sp;       ///< 1/m
    double o_range, s_range;     ///< (o_r − o_p)/o_p, (s_r − s_p)/s_p (combined)
};

}  // namespace graincrack
