// The stable time step of the assembled system.
#pragma once

#include "solver/assemblage.hpp"
#include "solver/boundary.hpp"
#include "solver/contact_law.hpp"

namespace graincrack {

/// Largest stable step 2/ω_max of central differences, s, for the stiffest state the system can reach: every contact at its
/// initial stiffness (in the literal reading an open contact shears with kt), every boundary node that can touch a platen
/// touching it. ω_max² is the largest eigenvalue of M⁻¹K, found by Lanczos' method; its residual and a margin are
/// added, so that the result stays below the exact value, by less than 1 %. Local damping α is always against a mode that
/// turns at every step, and stiffens it by 1 + α: with it a step is stable below 1/√(1 + α) of this one.
/// \throws NumericalError if the iteration does not settle
double stable_time_step(const Assemblage& assemblage, const Boundary& boundary, const ContactLaw& law);

/// y = K x of that stiffest state, linear about the reference (for `stable_time_step` and its tests).
void apply_stiffness(const Assemblage& assemblage, const Boundary& boundary, const ContactLaw& law, const std::vector<Vector2>& x,
                     std::vector<Vector2>& y);

}  // namespace graincrack
