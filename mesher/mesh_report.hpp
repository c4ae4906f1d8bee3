// Report of graincrack-mesh about a mesh, on stderr.
#pragma once

#include <string>
#include <vector>

#include "mesher/mesh.hpp"
#include "share/base/events.hpp"
#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"

namespace graincrack::mesher {

// Warnings say that something is wrong; the other lines are for those who ask for more.

/// What a specimen is: its shape, grains and elements, and a line with its phases, if it has several or one with a name.
/// \param output name of its file, "" for none
std::vector<std::string> summary_of(const Specimen& specimen, const std::string& output);

/// Statistics of a specimen, a line each. Lengths in mm, angles in degrees.
std::vector<Remark> describe_mesh(const Specimen& specimen, const Request& request, const MeshReport& report);

/// Estimated counts, file size and time of a request, two lines. \throws UsageError as `plan_mesh`
std::vector<std::string> describe_plan(const Request& request);

/// How many elements, in mean lengths of contacts, lie in the zone in which the contacts of a material soften: of those between
/// and of those within crystals the class with the fewest, by the energies of the material. The fewest of all is a warning if it
/// is below one. Nothing if the specimen has other phases than the material.
std::vector<Remark> describe_zones(const Material& material, const Specimen& specimen);

}  // namespace graincrack::mesher
