// Rosettes: how much length of cracks, and of the specimen's own facets, has which orientation.
#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <vector>

#include "post/table/table.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// Lengths by orientation in bins of 10° from x, counter-clockwise, over [0°, 180°): bin i holds [10 i, 10 (i + 1)).
struct Rosette {
    static constexpr std::size_t n_bins = 18;
    std::array<double, n_bins> tensile{};  ///< length of tensile cracks, m
    std::array<double, n_bins> shear{};    ///< length of shear cracks, m
    std::array<double, n_bins> facet{};    ///< length of the contacts of the specimen, m
};

/// Bin of an orientation in rad, of any size: an orientation and its opposite are the same.
std::size_t rosette_bin(double orientation);

Rosette crack_rosette(const std::vector<Crack>& cracks, const Specimen& specimen);

/// Share of a length by orientation that lies within 30° of the load (y), by whole bins; empty where there is no length at all.
std::optional<double> share_along_load(const std::array<double, Rosette::n_bins>& length);

/// Table: orientation_low_deg, orientation_high_deg, then for tensile, shear and facet the length_m and the share of
/// the total (empty where there is no length at all).
void write_rosette(std::ostream& out, const Rosette& rosette, TableFormat format);

}  // namespace graincrack
