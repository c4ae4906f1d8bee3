// Makes a specimen from a request: the interface of the mesher.
#pragma once

#include "mesher/cells/tessellation.hpp"
#include "mesher/fabric/fabric.hpp"
#include "mesher/region/shapes.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Makes the specimen: region with fitted flaws → cells → elements → bodies → fabric. Equal requests give equal specimens, bit
/// for bit.
/// \param report receives the measures unless it is null \throws UsageError as `plan_mesh`; Interrupted on a signal
Specimen mesh(const Request& request, const ProgressCallback& progress = {}, MeshReport* report = nullptr);

}  // namespace graincrack::mesher
