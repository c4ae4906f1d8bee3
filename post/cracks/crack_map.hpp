// One frame of a run as files for ParaView: grains and cracks.
#pragma once

#include <string>
#include <vector>

#include "post/cracks/fragments.hpp"
#include "post/run/crack_label.hpp"
#include "share/file/platen_faces.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// The state of a test at the time of a frame; field data of every file: time (s), axial_strain (elongation positive),
/// axial_stress (Pa, tension positive). Zeros for a run without platens.
struct FrameMoment {
    double time = 0;          ///< s
    double axial_strain = 0;  ///< of the platens' approach, elongation positive
    double axial_stress = 0;  ///< Pa, tension positive; brazilian: load over D t
};

/// One frame as .vtu: triangles in reference position.
///
/// Cell data: grain, phase, fragment (0 the largest), stress (XX YY ZZ XY YZ XZ, Pa, tension positive),
/// principal_stress_1 ≥ principal_stress_2 in the plane (Pa). Point data: displacement (m), velocity (m/s), as 3-vectors. Field
/// data: phase_names.
/// Places and displacements are doubles, the rest floats; LZ4. \param frame is consumed: its arrays are released as they are
/// written \throws OutputError
void write_grains(const std::string& path, const Specimen& specimen, Frame frame, const Fragments& fragments,
                  const FrameMoment& moment);

/// The cracks of a label up to the time of a frame as .vtp: a line along the facet of each contact point, centred where it
/// failed. Arrays have their units (`UNITS_LABEL`).
///
/// Cell data of the frame: opening, sliding (m), normal_traction (tension positive), shear_traction (Pa), stored_energy (J: what
/// the point would give back), damage, separated (1 if it had lost all strength by then), broken (1 if less than 10 % of its
/// cohesion was left by then). Cell data of the failure, or of the other event of the label: time_of_failure (s),
/// opening_at_failure, sliding_at_failure (m), mode (0 tensile, 1 shear), mode_angle (rad), mode_by_sign (0: open then). Of the
/// whole run: fracture_energy_at_end (J), time_broken (s, NaN until the end of the run). Besides contact, point, phase_a,
/// phase_b, class (as /contacts/class) and, where contacts have one, strength_factor. Field data: crack_label, the definition of
/// the label in words; mode_names, phase_names, class_names. Point data: displacement (m), from the place of failure to the place
/// in this frame, so that warping grains and cracks by `displacement` keeps them together. \param labelled_cracks of the whole
/// run \param contacts of the run by class, for the stored energy \throws OutputError
void write_cracks(const std::string& path, const Specimen& specimen, const std::vector<Crack>& labelled_cracks,
                  const Frame& frame, const CrackLabel& label, const std::vector<ContactParameters>& contacts,
                  const FrameMoment& moment);

/// Platens or rollers as .vtp: rectangles that touch the specimen at the start. \param height of the specimen, m Cell data:
/// platen (0 below, 1 above). Point data: displacement (m). \throws OutputError
void write_platens(const std::string& path, const PlatenFaceSet& platens, double height, const FrameMoment& moment);

/// "VTK 9.1.0".
std::string vtk_library_version();

}  // namespace graincrack
