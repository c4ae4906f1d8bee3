// Bending on three rollers: nominal stress, and stress intensity of notched specimens.
#pragma once

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
/// What that method suggests: s/2R, and a/R.
inline constexpr double least_span_of_half_disc = 0.5, largest_span_of_half_disc = 0.8;
inline constexpr double least_notch_of_half_disc = 0.4, largest_notch_of_half_disc = 0.6;

}  // namespace graincrack
