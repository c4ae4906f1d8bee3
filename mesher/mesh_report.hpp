// Reports of graincrack-mesh about a mesh, on stderr.
#pragma once

#include <string>
#include <vector>

#include "mesher/mesh.hpp"
#include "share/base/events.hpp"
#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"

namespace graincrack::mesher {

// Warnings report errors; the other lines are shown on request.

/// Summary of a specimen: its shape, grains and elements, and a line with its phases if it has several or a named one.
/// \param output name of its file, "" for none
std::vector<std::string> summary_of(const Specimen& specimen, const std::string& output);

/// Statistics of a specimen, one per line. Lengths in mm, angles in degrees.
std::vector<Remark> describe_mesh(const Specimen& specimen, const Request& request, const MeshReport& report);

/// Estimated counts, file size and time of a request, two lines. \throws UsageError as `plan_mesh`
std::vector<std::string> describe_plan(const Request& request);

/// Number of elements, in mean contact lengths, in the zone in which contacts of a material soften, by its energies: for the
/// class with the fewest between and within crystals. The smallest is a warning if it is below one. Empty if the specimen has
/// other phases than the material.
std::vector<Remark> describe_zones(const Material& material, const Specimen& specimen);

}  // namespace graincrack::mesher
