// The crystals of a specimen, one or several grains each. In a specimen without crystals each grain is one.
#pragma once

#include <array>
#include <cstddef>
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

/// The grains that were asked for, by a material or by options: "delaunay, grains 8, spread 0.1 (material gneiss)"; "" if the
/// file does not say.
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
