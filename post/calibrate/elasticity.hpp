// E and ν of the grains for which an assemblage has the rock's, by the compliance of its contacts.
#pragma once

#include "share/material.hpp"

namespace graincrack::calibrate {

/// E (Pa) and ν.
struct Elasticity {
    double young_modulus = 0;
    double poisson_ratio = 0;
};

/// The grains for which assemblages would have the wanted elasticity, from assemblages whose grains have `grains.rock`: measured
/// over predicted E, and measured − predicted ν, stay as they are; the contact length per area is that of the prediction.
/// \param grains material whose [rock] the assemblages had
/// \throws InputError if the prediction is no softer than the grains
Elasticity grains_for(const Material& grains, const Elasticity& measured, const Elasticity& predicted, const Elasticity& wanted);

}  // namespace graincrack::calibrate
