// What the mesher was asked for, and the crystals that it made.
#pragma once

#include <optional>
#include <string>

#include "share/file/h5_file.hpp"

namespace graincrack {

/// The value of an option by which the specimen of a file was made, as it was given; nothing if the file does not say.
/// \param key its name in a configuration file, "grain-size"
std::optional<std::string> specimen_option(const H5Input& file, const std::string& key);

/// The grains that were asked for, by a material or by options: "delaunay, grain-size 3.811 mm, spread 0.1 (material
/// augig-granite-triangles)"; "" if the file does not say.
std::string asked_grains(const H5Input& file);

/// The polygons of a specimen.
struct CrystalSizes {
    std::size_t n = 0;
    double mean_diameter = 0;  ///< of circles of their areas, m
    double variation = 0;      ///< coefficient of variation of these
    double elements = 0;       ///< of a crystal on average
};
/// Nothing for grains that are no polygons of the mesher.
std::optional<CrystalSizes> crystal_sizes(const H5Input& file);

}  // namespace graincrack
