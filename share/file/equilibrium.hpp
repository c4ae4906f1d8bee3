// Whether a test was near equilibrium, as its strength supposes: evaluated from its header and history alone.
#pragma once

#include <string>

#include "share/file/run_file.hpp"

namespace graincrack {

/// What a test far from equilibrium is told, naming the measure; "" for one that is not.
std::string equilibrium_warning(const RunHeader& header, const History& history);

}  // namespace graincrack
