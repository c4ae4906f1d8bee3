// Fracture toughness from direct tension of plates with a notch through the middle.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "post/measure/load_curve.hpp"
#include "post/table/table.hpp"
#include "share/specimen.hpp"

namespace graincrack {

struct Toughness {
    double notch_length = 0;      ///< m, between the ends of the grain boundaries that were broken from the start
    double strength = 0;          ///< Pa, largest load over the whole width
    double mode_i_toughness = 0;  ///< Pa √m
    double predicted =
        0;  ///< Pa √m: √(E' Gf) of a straight crack along a contact, E' of the assemblage, E/(1 − ν²) in plane strain
};

/// Stress intensity K_I, Pa √m, of a plate of this width under this mean tensile stress, with a crack of this length in its
/// middle: σ √(π a) √sec(π a/W), a half the length (Feddersen 1966; within 0.3 % for 2a ≤ 0.7 W in a long plate).
double centre_crack_intensity(double stress, double length, double width);

/// \throws InputError if the run is no tension test of a rectangle with a notch in its middle, or has no peak
Toughness measure_toughness(const RunData& run, const Specimen& specimen);

/// Writes the table `toughness`, a row a run; see share/doc/tables.md.
void write_toughness_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format);

}  // namespace graincrack
