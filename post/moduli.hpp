// Young's modulus and Poisson's ratio of a test, by the paper's convention: the chord from the start to half the peak.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "post/load_curve.hpp"
#include "post/table.hpp"
#include "share/fracture_process_zone.hpp"

namespace graincrack {

/// Moduli of one run, Pa. "Plane" values are the slopes as they are; material values are converted from plane strain by
/// ν = ν'/(1+ν'), E = E'(1−ν²), and equal the plane ones in plane stress. Strains are those of the gauges over the
/// central half. In triaxial tests the chord begins at the end of the isotropic stage, so that the confinement is held.
struct Moduli {
    double young_modulus = 0;
    double poisson_ratio = 0;
    double plane_young_modulus = 0;
    double plane_poisson_ratio = 0;
    double platen_young_modulus = 0;  ///< material value from the platens' approach
};

/// Empty for a brazilian test, whose stress is not uniform. \throws InputError if the curve has no elastic part
std::optional<Moduli> measure_moduli(const RunData& run);

/// What the rock and its contacts' compliance predict for this assemblage (fpz::assemblage_moduli).
fpz::AssemblageModuli predict_moduli(const RunHeader& header, const Specimen& specimen);
/// Length of all contacts over the area of all grains, 1/m.
double contact_length_per_area(const Specimen& specimen);

/// Writes the table `moduli`, DESIGN's columns.
void write_moduli_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format);

}  // namespace graincrack
