// [ratios] of a material: contact values that follow from others, so that a kind of rock is described without numbers of one
// rock, and a calibration that moves the tensile strength takes the others with it.
#pragma once

#include <optional>
#include <vector>

#include "share/base/toml_keys.hpp"
#include "share/rock/contact_parameters.hpp"

namespace graincrack {

/// Ratios by the contact value that follows from each: tensile_strength tc over the tensile strength of the rock; cohesion and
/// open_shear_strength over tc; fracture_energy E G_I/tc² over the grain size, with E of the rock; mode_ii_fracture_energy over
/// G_I. Other members are not used.
using ContactRatios = GivenContact;

/// The keys of [ratios], bound to `ratios`, which must stay where it is; the ratio of the fracture energy is "process_zone".
std::vector<TomlKey> ratio_keys(ContactRatios& ratios);

/// `given`, and where it has no value what the ratios make of the values before it in the table of contact parameters; a value
/// stays unset if what it follows from is unset. \param grain_size mean equal-area diameter of the grains, m
GivenContact with_ratios(GivenContact given, const ContactRatios& ratios, const Rock& rock, std::optional<double> grain_size,
                         PlaneCondition plane);

}  // namespace graincrack
