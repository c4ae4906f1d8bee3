// Finds the stable time step of the assembled system.
#pragma once

#include "solver/law/contact_law.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"

namespace graincrack {

/// Returns the largest stable step 2/ω_max of central differences, s, in the stiffest state that the system can reach: every
/// contact has its initial stiffness (also in shear while open, if the law allows it), every boundary node that can meet a platen
/// meets it, and every other free face is held as by a bond of the stiffest class of its phase, because another grain may meet
/// it. ω_max² is the largest eigenvalue of M⁻¹K, found by Lanczos' method. Its residual and a margin are added, so that the
/// result stays below the exact value by less than 1 %. Local damping α acts against a mode that reverses at every step and
/// stiffens it by 1 + α; it reduces the stable step by 1/√(1 + α).
///
/// With mass scaling the result follows from the largest ω of the grains alone and that of contacts and platens alone, both with
/// unscaled masses. It is at most 2/ω of the stiffest grain alone.
/// \param mass_scaling_factor β; 0: no mass scaling
/// \throws NumericalError if the iteration does not converge
double stable_time_step(const Assemblage& assemblage, const Boundary& boundary, const ContactLaws& laws,
                        double mass_scaling_factor = 0);

/// Returns the factor β with which contacts and platens reduce the step of the grains alone by a twentieth only. A larger factor
/// would slow real motions without benefit. Measured: β is 80 to 110 for Augig granite in grains of 5 mm; Brazilian and uniaxial
/// strengths are within 0.4 % of those without mass scaling (contact law `consistent`, three seeds, 3 mm/s).
double sufficient_mass_scaling(const Assemblage& assemblage, const Boundary& boundary, const ContactLaws& laws);

}  // namespace graincrack
