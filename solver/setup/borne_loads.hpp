// Checks that supports bear the loads of a program, so that the specimen can come to rest under them.
#pragma once

#include "solver/model/assemblage.hpp"
#include "solver/model/prescribed.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// Largest unsupported resultant force or moment of loads that counts as balanced, over the sum of the magnitudes of all loads.
/// Chosen, not fitted.
inline constexpr double tolerated_resultant = 0.01;

/// Checks for the end of each stage that nodes with a prescribed velocity bear the resultant force and moment of the edge loads.
/// Platens bear any load. Gravity is left out, and waves leave no load behind. \throws InputError naming the stage if nothing
/// bears more than `tolerated_resultant`
void require_borne_loads(const Assemblage& assemblage, const PrescribedConditions& prescribed, const Program& program);

}  // namespace graincrack
