// Report of graincrack-mesh about a mesh, on stderr.
#pragma once

#include <string>
#include <vector>

#include "mesher/mesh.hpp"
#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"

namespace graincrack::mesher {

/// Statistics of a specimen, a line each. Lengths in mm, angles in degrees.
std::vector<std::string> describe_mesh(const Specimen& specimen, const Request& request, const MeshReport& report);

/// Expected counts and file size of a request, a line each. \throws UsageError as `plan_mesh`
std::vector<std::string> describe_plan(const Request& request);

/// Lengths with which a mean grain edge is compared, m.
struct SizeBounds {
    double lower = 0;                ///< 10 w_I, as printed in Eqs 15, 17
    double lower_shear = 0;          ///< 10 w_II, which the paper does not give
    double upper = 0;                ///< l/3 with Rice's zone l of the rock, Eqs 15–17
    double contact_zone_mixed = 0;   ///< zone of contacts that soften from tc with the mixed-mode fracture energy
    double contact_zone_mode_i = 0;  ///< the same with that of mode I alone
};

/// The lengths of a material; the contact zones are the same in plane strain and plane stress, as Ẽ Gf = K².
SizeBounds size_bounds(const Material& material);

/// A line for each length: what it is, its value, and how the mean edge compares with it.
std::vector<std::string> describe_size_check(const Material& material, double mean_edge);

}  // namespace graincrack::mesher
