// Comparison of runs: they may be combined in one mean or one fit, or not.
#pragma once

#include <string>
#include <vector>

#include "post/run/load_curve.hpp"

namespace graincrack {

/// The difference of two runs that makes them tests of different materials: contact law, choice of fracture energy, rock,
/// contact parameters; "" if nothing. Stiffnesses and fracture energy follow the plane condition and are
/// compared in one plane condition only.
std::string material_difference(const RunHeader& a, const RunHeader& b);

/// The difference of two runs of one test at one confining pressure, but for seeds, by which their mean has no meaning: plane
/// condition, rate, peak drop, damping, mass scaling, friction of the platens; "" if nothing.
std::string setting_difference(const RunHeader& a, const RunHeader& b);
/// \throws InputError if a run of a test at one pressure differs in its settings from an earlier one of that test
void require_same_settings(const std::vector<RunData>& runs, const std::string& what);

/// \param what requires equal materials, with an article: "an envelope" \throws InputError if the materials differ
void require_same_material(const RunData& run, const RunData& first, const std::string& what);

}  // namespace graincrack
