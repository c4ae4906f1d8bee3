// One frame of a run as files for ParaView: grains and cracks.
#pragma once

#include <string>
#include <vector>

#include "post/cracks/crack_label.hpp"
#include "post/cracks/fragments.hpp"
#include "share/run_file.hpp"

namespace graincrack {

/// One frame as .vtu: triangles in reference position.
///
/// Cell data: grain, phase, fragment (0 the largest), stress (XX YY ZZ XY YZ XZ, Pa, tension positive),
/// principal_stress_1 ≥ principal_stress_2 in the plane (Pa). Point data: displacement (m), velocity (m/s), as 3-vectors.
/// Places and displacements are doubles, the rest floats; LZ4. \param frame is consumed: its arrays are released as they are
/// written \throws OutputError
void write_grains(const std::string& path, const Specimen& specimen, Frame frame, const Fragments& fragments);

/// The cracks of a label up to the time of a frame as .vtp: a line along the facet of each contact point, centred where it
/// failed.
///
/// Cell data: mode (0 tensile, 1 shear), time (s), mode_angle (rad), opening, sliding (m, then), energy (J), contact,
/// point, separated (1 if it had lost all strength by the time of the frame), damage (in the frame), phase_a, phase_b,
/// mode_by_displacement (0: opening > |sliding|, then), broken (1 if less than 10 % of its cohesion was left by the time of the
/// frame), time_broken (s, NaN until the end of the run). Field data: crack_label, the definition of the label in words.
/// Point data: displacement (m), from the place of failure to the place in this frame, so that warping grains and cracks by
/// `displacement` keeps them together. \throws OutputError
/// \param labelled_cracks of the whole run
void write_cracks(const std::string& path, const Specimen& specimen, const std::vector<Crack>& labelled_cracks,
                  const Frame& frame, const CrackLabel& label);

/// "VTK 9.1.0".
std::string vtk_library_version();

}  // namespace graincrack
