// Fragments: grains connected by contacts that have not lost all strength.
#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <vector>

#include "post/table/table.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

struct Fragment {
    std::size_t grains = 0;
    std::size_t crystals = 0;        ///< that have a grain in it; of a specimen without them as many as grains
    double area = 0;                 ///< m²
    std::array<double, 2> centre{};  ///< of area, at the start of the test, m
    /// Diameter of the disc of equal area, m.
    [[nodiscard]] double diameter() const;
};

struct Fragments {
    std::vector<std::size_t> of_grain;  ///< [g] index into `all`
    std::vector<Fragment> all;          ///< largest first; equal ones in the order of their first grain
    [[nodiscard]] std::size_t single_grains() const;
};

/// True if a contact still connects its grains: a point of it is not separated.
bool holds(const std::array<std::uint8_t, 2>& points);

/// Centre of area of each grain, times its area, m³.
std::vector<std::array<double, 2>> first_moments(const Specimen& specimen);

/// Each crystal and each fragment that has a grain of it, ascending. \param fragment of each grain
std::vector<std::array<std::size_t, 2>> parts_of_crystals(const Specimen& specimen, const std::vector<std::size_t>& fragment);

/// Two grains are connected if a contact between them has a point that is not separated. \param state of the frame, [c]
Fragments find_fragments(const Specimen& specimen, const std::vector<std::array<std::uint8_t, 2>>& state);

/// Table: fragment, grains, area_mm2, diameter_mm, share_of_area, x_mm, y_mm, crystals.
void write_fragments(std::ostream& out, const Fragments& fragments, TableFormat format);

/// Fragmentation of a specimen: one row a frame.
struct FragmentCount {
    double time = 0;  ///< s
    std::size_t fragments = 0;
    std::size_t single_grains = 0;
    double largest_share = 0;        ///< area of the largest over that of all
    std::size_t split_crystals = 0;  ///< as of `count_split_crystals`
};
/// \return without the number of split crystals
FragmentCount count_fragments(const Fragments& fragments, double time);
/// Table: time_s, fragments, single_grains, largest_share_of_area, split_crystals.
void write_fragment_counts(std::ostream& out, const std::vector<FragmentCount>& counts, TableFormat format);

}  // namespace graincrack
