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

/// Two grains are connected if a contact between them has a point that is not separated. \param state of the frame, [c]
Fragments find_fragments(const Specimen& specimen, const std::vector<std::array<std::uint8_t, 2>>& state);

/// Table: fragment, grains, area_mm2, diameter_mm, share_of_area, x_mm, y_mm.
void write_fragments(std::ostream& out, const Fragments& fragments, TableFormat format);

/// Fragmentation of a specimen: one row a frame.
struct FragmentCount {
    double time = 0;  ///< s
    std::size_t fragments = 0;
    std::size_t single_grains = 0;
    double largest_share = 0;  ///< area of the largest over that of all
};
FragmentCount count_fragments(const Fragments& fragments, double time);
/// Table: time_s, fragments, single_grains, largest_share_of_area.
void write_fragment_counts(std::ostream& out, const std::vector<FragmentCount>& counts, TableFormat format);

}  // namespace graincrack
