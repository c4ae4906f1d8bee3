// Measures how near the specimen is to failing as a whole. The automatic loading rate slows down by it (share/doc/loading.md).
#pragma once

#include "solver/law/contact_law.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// Largest measure of failure that scattered points have while nothing slides: the load may then rise by 1 % in a wave transit at
/// the default tolerance. Chosen. First peaks of 28 specimens of Augig granite change by +0.4 ± 0.6 % against a limit of 1
/// (share/studies/equilibrium).
inline constexpr double most_scattered = 0.3;
/// Fraction of the external work that friction dissipates once sliding joins scattered failures to a section. Fitted: with 0.01
/// uniaxial first peaks are 0.5 ± 0.4 % higher. Measured in two of these specimens: below 0.002 up to 60 % of the strength, 0.005
/// at 75 %, 0.02 to 0.04 at 90 %, above 0.08 at the peak.
inline constexpr double sliding_section = 0.005;

/// Returns how far failure involves a section of the specimen, from 0 to 1. It is the larger of two ratios:
/// - The length of the longest chain of contacts near sliding or opening, over half the width of the specimen. One joint that
///   slides, or one crack that grows, lets the whole specimen move. Closed contacts without cohesion and node–edge contacts count
///   if their friction lies between half its limit and the limit. Contacts of laws that soften in shear also count while they are
///   open and lose their cohesion. Contacts at their limit, and those whose cohesion friction replaces, do not count: they do not
///   make failure sudden. Contacts join into a chain at common vertices of the mesh; the length of a chain is the diagonal of its
///   bounding rectangle in the reference positions.
/// - The number of intact points that would fail if their jumps grew by a quarter, over 6 % of all points (below 35 grains: over
///   half the square root of the number of points). While nothing slides they are scattered over the specimen and fail one by
///   one: the ratio is at most `most_scattered` then, and at most 1 from `sliding_section` on.
/// The cost is linear in the number of contacts. \param width of the specimen, m \param friction fraction of the recent external
/// work that friction dissipated
double near_failure(const Assemblage& assemblage, const ContactLaws& laws, const State& state, double width, double friction,
                    ThreadTeam& team);

}  // namespace graincrack
