// Fracture toughness from direct tension of plates with a notch through the middle, and from bending of beams and half-discs with
// a notch from below, on three rollers.
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/run/load_curve.hpp"
#include "post/table/table.hpp"
#include "share/file/specimen.hpp"

namespace graincrack {

/// Stress of the lowest fibre of an elastic beam in its middle, 3 F S/(2 t H²), Pa. \param load F/t, N/m
double nominal_bending_stress(double load, double span, double height);

/// Stress intensity K_I, Pa √m, of a beam with a notch from below at mid-span: the nominal bending stress times √H k(a/H, S/H) of
/// Guinea, Pastor, Planas & Elices (1998), for S ≥ 2.5 H and any notch; at S = 4 H within 0.5 % of ASTM E399 for a/H from 0.2 to
/// 0.8. \param load F/t, N/m
double notched_beam_intensity(double load, double notch, double span, double height);
inline constexpr double least_span_of_beam = 2.5;  ///< heights

/// Stress intensity K_I, Pa √m, of a half-disc with a notch from the middle of its flat side: F √(π a)/(2 R t) Y'(a/R, s/2R) of
/// ISRM (Kuruppu et al. 2014). \param load F/t, N/m
double half_disc_intensity(double load, double notch, double span, double radius);
/// Ranges of s/2R and a/R that the method suggests.
inline constexpr double least_span_of_half_disc = 0.5, largest_span_of_half_disc = 0.8;
inline constexpr double least_notch_of_half_disc = 0.4, largest_notch_of_half_disc = 0.6;

/// Energy to open a contact fully, J/m²: G_I and Gb are areas under two linear softenings, from tc and σb, of which the higher
/// holds.
double total_fracture_energy(const ContactParameters& contact);

struct Toughness {
    double notch_length = 0;  ///< m, between the ends of the grain boundaries that were broken from the start
    std::optional<double> requested_notch_length;  ///< m; empty if the run does not say
    double crack_length = 0;                       ///< a: half the notch of a plate, that of a beam or half-disc, m
    double ligament = 0;                           ///< uncracked length before a tip, m
    double size = 0;                               ///< m: diameter of a half-disc, height of a beam, width of a plate
    double peak_load = 0;                          ///< N per metre of thickness
    double strength = 0;          ///< Pa, largest load over the whole width of a plate; in bending the nominal stress
    double mode_i_toughness = 0;  ///< Pa √m
    /// Pa √m: √(E' G) of a straight crack along a contact, E' of the assemblage, E/(1 − ν²) in plane strain, G with bridges
    double predicted = 0;
    double characteristic_length = 0;        ///< l_ch = E' G/tc² (Hillerborg et al. 1976), m: the scale of the process zone
    double zone = 0;                         ///< ρ of the strip-yield law at the measured toughness, with σt = tc, m
    std::optional<double> by_strip_yield;    ///< what a specimen of this size shows of `predicted`, Pa √m
    std::optional<double> at_infinite_size;  ///< of a rock whose specimen shows the measured toughness, Pa √m
    std::string outside;                     ///< where the formula is used beyond what it was made for; else empty
    /// a/l_ch: small-scale yielding, on which K_IC rests, needs it large.
    [[nodiscard]] double notch_ratio() const { return crack_length / characteristic_length; }
    [[nodiscard]] double ligament_ratio() const { return ligament / characteristic_length; }
    /// Why the measured toughness may not be K_IC; empty if there is no caveat.
    [[nodiscard]] std::string warning() const;
};
/// a/l_ch below which the process zone is no small part of the notch, and the measured toughness is too low. The ligament has the
/// same limit.
inline constexpr double min_notch_ratio = 5;
/// Relative difference of the notch from the requested one from which it is said.
inline constexpr double notch_tolerance = 0.05;

/// Stress intensity K_I, Pa √m, of a plate of this width under this mean tensile stress, with a crack of this length in its
/// middle: σ √(π a) √sec(π a/W), a half the length (Feddersen 1966; within 0.3 % for 2a ≤ 0.7 W in a long plate).
double centre_crack_intensity(double stress, double length, double width);

/// A specimen under a fixed load, and the strip-yield law of its size, after Ghouli et al. (2021, Rock Mech Rock Eng 54,
/// 4041-4058), who found it for half-discs of three rocks with radii from 25 to 300 mm: the zone before a crack is as long as a
/// strip that yields at the tensile strength, and the crack grows when the energy released over that length is the rock's. How
/// the release is averaged follows here from these two statements. The law assumes that the zone bears the whole tensile
/// strength; one that softens is longer, and shows less.
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

/// \throws InputError if the run is neither a tension test of a rectangle with a notch in its middle nor bending of a beam or
/// half-disc with a notch from the middle of its lower side, or has no peak
Toughness measure_toughness(const RunData& run, const Specimen& specimen);
/// The same, with the requested notch, which the run records. \param run the data of `reader`
Toughness measure_toughness(const RunReader& reader, const RunData& run);

/// Writes the table `toughness`, one row per run; see share/doc/columns.tsv. \param diagnostics gets the warnings, one line per
/// run
void write_toughness_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format,
                           std::ostream& diagnostics);

}  // namespace graincrack
