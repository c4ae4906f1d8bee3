// Labels of axes and legends from the names of columns.
#pragma once

#include <string>

namespace graincrack {

/// "contact_cohesion_MPa" → "contact cohesion, MPa"; "friction_angle_deg" → "friction angle, °".
std::string column_label(const std::string& column);

}  // namespace graincrack
