// How near the specimen is to failing as a whole: what the automatic rate slows down for (share/doc/loading.md).
#pragma once

#include "solver/law/contact_law.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// How far failure involves a section of the specimen, 0 to 1; the larger of two ratios:
/// - length of the longest chain of contacts that are near sliding or open, over half the width of the specimen: one joint that
///   slides, or one crack that grows, lets the whole specimen move. Contacts count that have no cohesion, are closed and whose
///   friction is between half its limit and the limit; so do node–edge contacts; and, of laws that soften in shear, those that
///   lose their cohesion while open: what opens under another law counts once it has closed. What bears its limit already, or
///   softens under friction that takes over, does not make failure sudden. Chains meet at vertices of the mesh, and their length
///   is the diagonal of the rectangle that holds them in the reference.
/// - number of intact points that would fail if their jumps grew by a quarter, over 6 % of all points (over half the root of
///   their number, if that is more: fewer than 35 grains): fewer than that are scattered, and fail one by one.
/// \param width of the specimen, m
double near_failure(const Assemblage& assemblage, const ContactLaws& laws, const State& state, double width, ThreadTeam& team);

}  // namespace graincrack
