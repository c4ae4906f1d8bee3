// Fragments: grains connected by contacts that have not lost all strength.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
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

/// Two grains are connected if a contact between them has a point that is not separated. \param state of the frame, [c]
Fragments find_fragments(const Specimen& specimen, const std::vector<std::array<std::uint8_t, 2>>& state);

/// Table: fragment, grains, area_mm2, diameter_mm, share_of_area, x_mm, y_mm, crystals.
void write_fragments(std::ostream& out, const Fragments& fragments, TableFormat format);

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

/// Crystals with cracks of a mode within them; one with cracks of both modes counts for both. \param cracks labelled ones
/// \param until only cracks that are there at this time, s
ModeCounts count_cracked_crystals(const Specimen& specimen, const std::vector<Crack>& cracks, std::optional<double> until = {});

}  // namespace graincrack
