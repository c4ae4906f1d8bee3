// The crystals of a specimen after a test: cracks within and around each, and the pieces it is in.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/cracks/fragments.hpp"
#include "post/run/crack_label.hpp"
#include "post/table/table.hpp"

namespace graincrack {

struct Crystal {
    std::string phase;
    std::size_t grains = 0;
    double area = 0;                 ///< m²
    std::array<double, 2> centre{};  ///< of area, at the start of the test, m
    ModeCounts within;               ///< cracks of contacts within it
    ModeCounts around;               ///< of contacts with other crystals, each of which counts for both
    std::size_t pieces = 0;          ///< that contacts within it hold together, as in `find_fragments`
    std::size_t fragments = 0;       ///< of the specimen that have a part of it
};

/// \param cracks labelled ones \param state of a frame, [c] \param fragments of that frame
std::vector<Crystal> find_crystals(const Specimen& specimen, const std::vector<Crack>& cracks,
                                   const std::vector<std::array<std::uint8_t, 2>>& state, const Fragments& fragments);

/// Table: crystal, phase, grains, area_mm2, x_mm, y_mm, tensile_cracks_within, shear_cracks_within, tensile_cracks_around,
/// shear_cracks_around, pieces, fragments.
void write_crystals(std::ostream& out, const std::vector<Crystal>& crystals, TableFormat format);

/// Crystals of more than one piece. \param state of a frame, [c]
std::size_t count_split_crystals(const Specimen& specimen, const std::vector<std::array<std::uint8_t, 2>>& state);

/// Crystals with cracks of a mode within them; one with cracks of both modes counts for both. \param cracks labelled ones
/// \param until only cracks that are there at this time, s
ModeCounts count_cracked_crystals(const Specimen& specimen, const std::vector<Crack>& cracks, std::optional<double> until = {});

}  // namespace graincrack
