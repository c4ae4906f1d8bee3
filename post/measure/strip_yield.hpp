// The toughness that a specimen of a size shows, and that of the rock at infinite size, by the strip-yield law.
//
// Pure functions after Ghouli et al. (2021, Rock Mech Rock Eng 54, 4041-4058), who found it for half-discs of three rocks with
// radii from 25 to 300 mm: the zone before a crack is as long as a strip that yields at the tensile strength, and the crack grows
// when the energy released over that length is the rock's. How the release is averaged follows here from these two statements.
// The law assumes that the zone bears the whole tensile strength; one that softens is longer, and shows less.
#pragma once

#include <functional>
#include <optional>

namespace graincrack {

/// A specimen under a fixed load.
struct CrackedSpecimen {
    double crack = 0;                         ///< a, m
    double deepest = 0;                       ///< the longest crack whose stress intensity is known, m
    std::function<double(double)> intensity;  ///< K_I by the length of the crack, in any unit: only ratios matter
};

/// Length of the zone, ρ = (π/8) (K/σt)², m. \param shown K_IC as the specimen shows it, Pa √m
double strip_yield_zone(double shown, double tensile_strength);

/// K_∞, Pa √m, of a rock whose specimen shows K: K_∞² is the mean of K_I² over cracks from a to a + ρ under the load at which K_I
/// of a is K. Empty if a + ρ is longer than the deepest crack.
std::optional<double> toughness_at_infinite_size(double shown, double tensile_strength, const CrackedSpecimen& specimen);

/// The inverse: K, Pa √m, that a specimen shows of a rock with K_∞. Empty likewise.
std::optional<double> toughness_at_size(double infinite, double tensile_strength, const CrackedSpecimen& specimen);

}  // namespace graincrack
