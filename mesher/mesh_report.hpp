// Report of graincrack-mesh about a mesh, on stderr.
#pragma once

#include <string>
#include <vector>

#include "mesher/mesh.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Statistics of a specimen, a line each. Lengths in mm, angles in degrees.
std::vector<std::string> describe_mesh(const Specimen& specimen, const Request& request, const MeshReport& report);

/// Expected counts and file size of a request, a line each. \throws UsageError as `plan_mesh`
std::vector<std::string> describe_plan(const Request& request);

}  // namespace graincrack::mesher
