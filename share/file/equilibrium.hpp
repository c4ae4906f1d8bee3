// Whether a test was near equilibrium, as its strength supposes: evaluated from its header and history alone.
#pragma once

#include <string>

#include "share/file/run_file.hpp"

namespace graincrack {

/// Share of the load at the peak that it rises by while a wave crosses the specimen, beyond which a run warns. Measured,
/// strengths against those at the automatic rate: UCS of 1,122 grains 1 % too high at 0.0067, 2 % at 0.013, 4 % at 0.026; ten
/// tests at 4 MPa 0.3 % at 0.002 to 0.004 (share/doc/loading.md); a rectangle of 300 grains 3.5 % at 0.004, a disc of as many
/// 18 % at 0.015.
inline constexpr double trusted_load_rise = 5e-3;
/// Difference of the platen forces before the peak, over their mean, beyond which a run warns. The strength is from their mean.
inline constexpr double trusted_force_difference = 0.05;
/// Mean unbalanced ratio before the peak beyond which a run warns. Measured on 300 grains: damped tests at the automatic rate,
/// which holds it below 0.002 while there is damage, have 3e-5 to 3e-4 and the strengths of slower ones; without damping it is
/// 0.007 in a rectangle and 0.008 in a disc, with 0.37 and 0.47 times these strengths, and 0.0008 in a tension test with the same
/// strength.
inline constexpr double trusted_unbalanced_ratio = 3e-3;

/// 2 v/(c ε) with the speed v of each platen and the strain ε at the largest load, c = √(E/ρ): what the load rises by, relative
/// to itself, while a wave runs through the specimen. 0 for a program, which may move otherwise, and without any strain.
double load_rise_at_peak(const RunHeader& header, const History& history);

/// Mean unbalanced ratio while the last tenth of the strain at the largest load is reached. 0 for a program.
double unbalanced_before_peak(const RunHeader& header, const History& history);

/// What a test far from equilibrium is told, naming the measure; "" for one that is not.
std::string equilibrium_warning(const RunHeader& header, const History& history);

}  // namespace graincrack
