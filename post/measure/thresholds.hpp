// Crack initiation and crack damage: stresses at which a compression test leaves elasticity, by named methods.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/run/load_curve.hpp"

namespace graincrack {

/// The meaning of "volume" in a plane model. Neither compares with a laboratory value directly: there a cylinder widens to all
/// sides, here one side is held (plane strain) or free (plane stress).
enum class VolumeKind {
    plane,     ///< ε1 + ε3, the change of area; in plane strain the true change of volume
    pseudo_3d  ///< ε1 + 2 ε3, as if the third direction widened like the lateral one
};

/// Stresses in Pa, strains by the gauges over the central half, contraction positive. Empty: not reached before the peak.
struct Thresholds {
    /// Stress at which the crack strain (volumetric strain less the elastic line, Martin & Chandler 1994) has fallen by
    /// `crack_strain_offset`. The elastic line is fitted between `elastic_share` of the way to the peak.
    std::optional<double> initiation_by_crack_strain;
    /// Largest contraction (Bieniawski 1967): from there on the specimen dilates.
    std::optional<double> damage;
};
inline constexpr double crack_strain_offset = 1e-5;
inline constexpr double elastic_share[2] = {0.1, 0.3};

Thresholds measure_thresholds(const LoadCurve& curve, VolumeKind kind);

/// Volumetric strain by the gauges in each row, contraction positive.
std::vector<double> volumetric_strain(const LoadCurve& curve, VolumeKind kind);

/// A volumetric strain less its elastic line in each row, contraction positive; empty if there is no such line.
std::vector<double> crack_strain(const LoadCurve& curve, const std::vector<double>& volume);

/// Stress at which there are as many cracks in the history as `share` of those at the peak, Pa; empty without any.
std::optional<double> initiation_by_count(const RunData& run, const LoadCurve& curve, double share = 0.01);

/// The same by the contact points that were damaged by 10 %.
std::optional<double> initiation_by_damage(const RunData& run, const LoadCurve& curve, const std::vector<Crack>& cracks,
                                           double share = 0.01);

/// The thresholds of a compression test by all definitions, Pa. The default ones are those that the strain gauges of a
/// laboratory tell. Its specimen is a cylinder, whose volume is ε1 + 2 ε3. The crack strain is the most used and
/// does not need that crack damage is reached. A count of cracks is a stand-in for acoustic emission, and
/// depends on which event of the contact law is counted.
struct AllThresholds {
    Thresholds plane;
    Thresholds pseudo_3d;
    std::optional<double> initiation_by_count;
    std::optional<double> initiation_by_damage;

    /// The default crack initiation, CI: onset of the pseudo-3D crack strain.
    [[nodiscard]] std::optional<double> initiation() const { return pseudo_3d.initiation_by_crack_strain; }
    /// The default crack damage, CD: reversal of the pseudo-3D volumetric strain.
    [[nodiscard]] std::optional<double> damage() const { return pseudo_3d.damage; }
};
/// The default definitions in words.
inline constexpr const char* default_initiation_name = "onset of crack volumetric strain";
inline constexpr const char* default_damage_name = "reversal of volumetric strain";

/// \param cracks the log of the run; without it no value is by damage
AllThresholds measure_all_thresholds(const RunData& run, const LoadCurve& curve, const std::vector<Crack>& cracks);

}  // namespace graincrack
