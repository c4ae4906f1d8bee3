// The crystals of a specimen, one or several grains each, and the options by which the mesher made it. In a specimen without
// crystals each grain is one.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "share/file/h5_file.hpp"
#include "share/file/specimen_measures.hpp"

namespace graincrack {

std::size_t crystal_of(const Specimen& specimen, std::size_t grain);

/// The two grains of each contact [c].
std::vector<std::array<std::size_t, 2>> grains_of_contacts(const Specimen& specimen);

/// True if a contact is within a crystal.
bool is_within_crystal(const Specimen& specimen, std::size_t contact);

/// "452 grains" or, of polygons that break, "300 crystals of 2168 elements".
std::string grains_label(const Specimen& specimen);

/// The options by which the specimen of a file was made, by their keys in a configuration file ("grain-size"), as they were
/// given, several values of one with "; " between; none if the file does not say.
std::map<std::string, std::string> specimen_options(const H5Input& file);

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
    double area = 0;           ///< of all, m²
};
/// Of the crystals of a file, or of grains that are no crystals; nothing if it has no areas.
std::optional<CrystalSizes> sizes_of_grains(const H5Input& file);
/// Nothing for grains that are no polygons of the mesher.
std::optional<CrystalSizes> crystal_sizes(const H5Input& file);

}  // namespace graincrack
