// The state of a test on a map, as every picture of it shows it: grains, platens, cracks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/chart/map_view.hpp"
#include "post/run/crack_label.hpp"
#include "post/run/load_curve.hpp"
#include "share/file/platen_faces.hpp"

namespace graincrack {

/// Platens, and the axial strain by which they have moved, elongation positive.
struct PlatensAtStrain {
    PlatenFaceSet faces;
    double axial_strain = 0;
};
/// Direct tension pulls at the ends of the specimen: there are no platens.
bool has_platens_to_draw(const RunData& run);
bool has_pre_existing_cracks(const Specimen& specimen);

/// Draws grains, platens, cracks from before the test, and those of the test: tensile above shear, thin within crystals.
/// \return whether there are cracks from before the test
bool draw_crack_state(MapView& map, const Specimen& specimen, const std::optional<PlatensAtStrain>& platens,
                      const std::vector<Crack>& present);

/// The number of contacts with cracks of a mode, as a legend has it.
std::string cracked_contacts(const std::vector<Crack>& cracks, CrackMode mode);
/// The definition of the cracks of a picture in lines. \param classes that they are limited to
std::vector<std::string> crack_notes(const Specimen& specimen, const CrackLabel& label, const std::vector<std::string>& classes);

}  // namespace graincrack
