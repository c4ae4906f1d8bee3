// Adds mass to the few elements that would require the shortest steps.
#pragma once

#include "solver/model/assemblage.hpp"

namespace graincrack {

/// Largest mass that a run with mass scaling adds to elements, over the mass of the specimen. Chosen, not fitted.
inline constexpr double max_added_mass = 0.1;

/// Increases the density of the elements with the highest frequencies, which are slivers and limit the step with mass scaling,
/// until none is above a common level. The centre of mass of an element stays in place. The added mass is inertia only: gravity
/// acts on the mass of the rock. No frequency of an assembly of elements is above the highest of its elements (B. M. Irons, 1970,
/// Int J Numer Methods Eng 2). `stable_time_step` finds the step with these masses.
///
/// \param fraction largest mass to be added, over the mass of the specimen, ≥ 0
/// \return the added fraction
double scale_mass_of_stiffest_elements(Assemblage& assemblage, double fraction);

}  // namespace graincrack
