// The stable time step of the assembled system.
#pragma once

#include "solver/law/contact_law.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"

namespace graincrack {

/// Largest stable step 2/ω_max of central differences, s, for the stiffest state the system can reach: every contact at its
/// initial stiffness (in the literal reading an open contact shears with kt), every boundary node that can touch a platen
/// touching it, every other free face held as a bond of the stiffest class of its phase would hold it (another grain may touch
/// it). ω_max² is the largest eigenvalue
/// of M⁻¹K, found by Lanczos' method; its residual and a margin are added, so that the result stays below the exact value, by
/// less than 1 %. Local damping α is always against a mode that
/// turns at every step, and stiffens it by 1 + α: with it a step is stable below 1/√(1 + α) of this one.
///
/// With mass scaling the result follows from the largest ω of grains alone and that of contacts and platens alone, both with the
/// masses as they are. It is at most 2/ω of the stiffest grain alone.
/// \param mass_scaling_factor β; 0: no mass scaling
/// \throws NumericalError if the iteration does not settle
double stable_time_step(const Assemblage& assemblage, const Boundary& boundary, const ContactLaws& laws,
                        double mass_scaling_factor = 0);

/// The factor β with which contacts and platens leave the grains' own step but for a twentieth: more would slow what moves and
/// gain nothing. For Augig granite in grains of 5 mm it is 80 to 110; Brazilian and uniaxial strengths with it are within 0.4 %
/// of those without (contact law `consistent`, three seeds, 3 mm/s).
double sufficient_mass_scaling(const Assemblage& assemblage, const Boundary& boundary, const ContactLaws& laws);

}  // namespace graincrack
