// Labels of axes and legends from the names of columns.
#pragma once

#include <string>

namespace graincrack {

/// "contact_cohesion_MPa" → "contact cohesion, MPa"; "phi_deg" → "φ, °"; "young_modulus_GPa" → "Young's modulus, GPa".
std::string column_label(const std::string& column);
/// The name of a mineral or of a pair of them in print: "k_feldspar" → "K-feldspar"; "k_feldspar-mica" → "K-feldspar–mica".
std::string mineral_label(const std::string& name);

}  // namespace graincrack
