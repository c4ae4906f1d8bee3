// The constants of a contact law, derived once from the parameters of a contact.
#pragma once

#include "solver/law/types.hpp"

namespace graincrack {

/// Constants of a law. Symbols as in the paper. \see make_contact_law
struct ContactLaw {
    LawVariant variant;
    Coupling coupling;
    double kt, ks;  ///< initial stiffnesses (Eqs 3–5), Pa/m
    double tc;      ///< tensile strength, Pa
    double tan_phi;
    double dct, dcs, dut;  ///< δct, δcs, δut (Eqs 8, 11, 14), m
    double w;              ///< the open branch starts with the shear stiffness w kt: 1 (literal) or κ = ks/kt
    double inv_dct, inv_dcs;
    double inv_dso;  ///< 1/δso, δso = e tc/ks (consistent)
    double gf;       ///< Gf, J/m²
};

}  // namespace graincrack
