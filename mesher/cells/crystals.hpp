// A region divided into crystals: polygons of given areas.
#pragma once

#include "mesher/cells/tessellation.hpp"

namespace graincrack::mesher {

/// The number, the edge and the size of elements of crystals are planned.
MeshPlan plan_crystals(const Request& request);

/// Makes cells of requested areas, without short edges. What the removal of short edges does to areas is undone by small moves of
/// the cells' points, which then move to where elements are better. Elongated cells are made in the plane in which they are
/// equiaxed. Of graded crystals the requested areas follow from the size where they come to lie (`GradedAreas`). Prescribed edges
/// become sides of crystals.
/// \throws UsageError if walls leave no room; Interrupted on a signal
TessellatedRegion crystals(const Request& request, MeshPlan plan, const ProgressCallback& progress);

}  // namespace graincrack::mesher
