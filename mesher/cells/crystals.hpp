// Divides a region into crystals: polygons of given areas.
#pragma once

#include "mesher/cells/tessellation.hpp"

namespace graincrack::mesher {

/// Plans the number, the edge and the element size of crystals.
MeshPlan plan_crystals(const Request& request);

/// Makes cells of requested areas without short edges. Small moves of their points undo the changes of area by the removal of
/// short edges; then points move to places with better elements. Elongated cells are made in the plane in which they are
/// equiaxed. Requested areas of graded crystals follow from the size at their final places (`GradedAreas`). Prescribed edges
/// become sides of crystals.
/// \throws UsageError if walls leave no room; Interrupted on a signal
TessellatedRegion crystals(const Request& request, MeshPlan plan, const ProgressCallback& progress);

}  // namespace graincrack::mesher
