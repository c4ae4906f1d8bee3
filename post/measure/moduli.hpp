// Young's modulus and Poisson's ratio of a test by the conventions that laboratories use, and the moduli that the contact
// compliance predicts.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "post/run/load_curve.hpp"
#include "post/table/table.hpp"
#include "share/rock/fracture_process_zone.hpp"

namespace graincrack {

/// Moduli by one convention, Pa. "Plane" values are the slopes as they are; material values are converted from plane strain
/// by ν = ν'/(1+ν'), E = E'(1−ν²), and equal the plane ones in plane stress.
struct ElasticPair {
    double young_modulus = 0;
    double poisson_ratio = 0;
    double plane_young_modulus = 0;
    double plane_poisson_ratio = 0;
};

/// Moduli of one run. Strains are those of the gauges over the central half; shares are those of the stress from the start to
/// the peak. In triaxial tests the start is the end of the isotropic stage, so that the confinement is held.
struct Moduli {
    ElasticPair chord;                ///< from the start to half the peak: the convention of the paper
    ElasticPair tangent;              ///< least squares between 40 and 60 % (ISRM 1979: tangent at half the strength)
    ElasticPair average;              ///< least squares between 20 and 80 % (ISRM 1979: average of the straight part)
    ElasticPair secant;               ///< from the start to the peak: the deformation modulus, failure included
    double platen_young_modulus = 0;  ///< chord, material value, from the platens' approach
    /// Mean fall of stress over platen strain from the peak to where it has lost the drop that makes it a peak (at most
    /// 30 %), over the platens' plane chord modulus: 0 ductile, ∞ brittle. Empty if the test ended before.
    std::optional<double> post_peak_slope_ratio;
};

/// Largest difference between the moduli by gauges and by platens. In equilibrium they are equal but for end effects (1 % in
/// rectangles of 1,122 grains); a stress wave that still travels through the specimen makes them differ.
inline constexpr double gauge_tolerance = 0.03;

/// Empty for Brazilian tests and bending, whose stress is not uniform. \throws InputError if the curve has no elastic part
std::optional<Moduli> measure_moduli(const RunData& run);

/// E and ν of the grains alone, without their contacts, from those of the phases by area.
struct GrainModuli {
    double voigt = 0;  ///< mean of E: as if strains were equal, the upper bound, Pa
    double reuss = 0;  ///< E of the mean of 1/E: as if stresses were equal, the lower bound, Pa
    double poisson_ratio = 0;
    [[nodiscard]] double hill() const { return 0.5 * (voigt + reuss); }  ///< Pa
};
GrainModuli grain_moduli(const RunSettings& header, const Specimen& specimen);

/// The moduli that the grains (Hill's mean over their phases) and the compliance of their contacts predict for this assemblage
/// (fpz::assemblage_moduli).
fpz::AssemblageModuli predict_moduli(const RunSettings& header, const Specimen& specimen);
/// Length of all contacts over the area of all grains, 1/m.
double contact_length_per_area(const Specimen& specimen);

/// Writes the table `moduli`; its columns are those of share/doc/columns.tsv. \param diagnostics gets a line for each reason to
/// doubt
void write_moduli_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format, std::ostream& diagnostics,
                        ColumnChoice columns = ColumnChoice::all);

}  // namespace graincrack
