// Picture of a specimen: its grains by phase or its contacts by strength, its rim, its pre-existing cracks.
#pragma once

#include <string>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"
#include "share/file/specimen.hpp"

namespace graincrack {

/// What the colours of a specimen show.
enum class SpecimenColour {
    phase,    ///< grains by phase
    strength  ///< contacts by their strength factor
};
/// \throws InputError for colours of strength factors that the specimen does not have; its file has the name `file`
Drawing draw_specimen(const Specimen& specimen, const std::string& file, SpecimenColour colour = SpecimenColour::phase,
                      const PictureStyle& style = {});

Command specimen_plot();

}  // namespace graincrack
