// Mass on top for the few elements that would ask for the shortest steps.
#pragma once

#include "solver/model/assemblage.hpp"

namespace graincrack {

/// Largest mass that a run with mass scaling adds to elements, over the mass of the specimen.
inline constexpr double max_added_mass = 0.02;

/// Makes those elements denser that have the highest frequencies, slivers, so that none is left above a common level: they limit
/// the step with mass scaling. An element's centre of mass stays, and what rests does not feel it; gravity pulls the mass of the
/// rock. No frequency of an assembly of elements is above the highest of its elements (B. M. Irons, 1970, Int J Numer Methods Eng
/// 2). The stable step itself is found as ever, by `stable_time_step`.
///
/// \param fraction of the mass of the specimen to be added at most, ≥ 0
/// \return fraction that was added
double scale_mass_of_stiffest_elements(Assemblage& assemblage, double fraction);

}  // namespace graincrack
