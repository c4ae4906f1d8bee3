// The closure of a joint as given: its traction and energy normal to its faces.
//
//   σn = kt δn,  and beyond the maximum closure Vm, where it is shut,  σn = −kt Vm + k (δn + Vm)
//
// k, the stiffness of shut joints, is that of a grain boundary of the rock unless given; Vm is infinite where a joint is never
// shut.
#pragma once

#include <algorithm>

#include "solver/law/types.hpp"

namespace graincrack::contact_law {

/// Pa. Has no branch, so that vector units can work on it.
inline double joint_traction(const ContactLaw& law, double opening) {
    return law.kt * std::max(opening, -law.maximum_closure) + law.stiffest_normal * std::min(opening + law.maximum_closure, 0.0);
}
/// Stored in it, J/m².
inline double joint_energy(const ContactLaw& law, double opening) {
    const double before = std::max(opening, -law.maximum_closure);
    const double beyond = opening - before;
    return 0.5 * (law.kt * before * (before + 2 * beyond) + law.stiffest_normal * beyond * beyond);
}

}  // namespace graincrack::contact_law
