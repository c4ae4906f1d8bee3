// Checks from the header and history of a test that it was near equilibrium, as its strength assumes.
#pragma once

#include <string>

#include "share/file/run_file.hpp"

namespace graincrack {

/// Returns the warning for a test far from equilibrium, naming the measure; "" for other tests.
std::string equilibrium_warning(const RunHeader& header, const History& history);

}  // namespace graincrack
