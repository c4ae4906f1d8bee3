// Whether something bears the loads of a program, so that the specimen can come to rest under them.
#pragma once

#include "solver/model/assemblage.hpp"
#include "solver/model/prescribed.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// The resultant and the moment of loads that nothing bears, over the sum of their magnitudes, up to which they count as
/// balanced.
inline constexpr double tolerated_resultant = 0.01;

/// Checks at the end of each stage that what its loads exert on the whole specimen is borne: by nodes whose velocity is
/// prescribed, or by platens, which bear all. Gravity is left out, and waves leave no load behind. \throws InputError naming the
/// stage
void require_borne_loads(const Assemblage& assemblage, const PrescribedConditions& prescribed, const Program& program);

}  // namespace graincrack
