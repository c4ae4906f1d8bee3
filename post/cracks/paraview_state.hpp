// A Python state that opens a folder of crack maps in ParaView.
#pragma once

#include <string>

namespace graincrack {

/// A script for `paraview --script FILE` and `pvbatch FILE PICTURE.png`, to be written beside grains.pvd and cracks.pvd. It opens
/// both series displaced, grains coloured by their largest principal stress from -`stress` to `stress`, cracks by their mode,
/// with the times of the frames, at the last one. \param stress Pa, above 0
std::string paraview_state(double stress);

}  // namespace graincrack
