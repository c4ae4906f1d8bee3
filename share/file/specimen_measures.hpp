// Measures of a specimen from its arrays: how platens meet it, its notch, the open part of its grain boundaries.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// Time in which a bar wave crosses the height of the specimen, h/√(E/ρ), s.
inline double bar_transit_time(const Specimen& specimen, const Rock& rock) {
    return specimen.height / std::sqrt(rock.young_modulus / rock.density);
}

/// Extent along x of a part of the boundary, m; 0 if there is none.
double width_of_part(const Specimen& specimen, BoundaryPart part);

/// True if platens meet a specimen at faces, the boundary parts bottom and top, that are at least half as wide as it. A disc has
/// none, or narrower flat poles: it is loaded along its diameter.
inline bool has_end_faces(const Specimen& specimen) {
    const double half = specimen.width / 2;
    return width_of_part(specimen, BoundaryPart::bottom) >= half && width_of_part(specimen, BoundaryPart::top) >= half;
}

/// Width between the platens to which load and strain refer, m: that of the end faces; without them half the width.
inline double loaded_width(const Specimen& specimen) { return specimen.width * (has_end_faces(specimen) ? 1.0 : 0.5); }

/// Ends along x, m, of the contacts broken at the start (kind `pre_existing_crack`); empty without any.
std::optional<std::array<double, 2>> notch_ends(const Specimen& specimen);

/// A notch that starts from the lower rim.
struct EdgeNotch {
    std::array<double, 2> mouth;  ///< m
    std::array<double, 2> tip;    ///< highest place connected with the mouth by such contacts, m
    [[nodiscard]] double length() const { return tip[1] - mouth[1]; }
};
/// Finds the notch among the contacts broken at the start; empty if none of them starts from the lower rim.
std::optional<EdgeNotch> edge_notch(const Specimen& specimen);

/// The part of the boundaries between crystals, flaws excluded, that is open at the start, "93 of 310, 0.301 of their length"; ""
/// if none is. All contacts between two crystals are one boundary.
std::string open_boundaries_text(const Specimen& specimen);

/// Contacts of flaws and joints by class, "joint 93 contacts, 295 mm long, intact"; "" if there are none. Those without a class
/// are cracks.
std::string flaws_text(const Specimen& specimen);

/// The number of crystals; grains count if each is a crystal.
std::size_t number_of_crystals(const Specimen& specimen);

/// Mean equal-area diameter of crystals, m.
double mean_crystal_diameter(const Specimen& specimen);

/// A note on a specimen with fewer than ten crystals of the mean equal-area diameter across its smaller extent, whose strengths
/// depend on single crystals; "" for others.
std::string note_on_few_crystals(const Specimen& specimen);

}  // namespace graincrack
