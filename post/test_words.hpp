// Words for tests and states in titles.
#pragma once

#include <string>

#include "post/load_curve.hpp"

namespace graincrack {

/// "Uniaxial compression, Augig granite"; triaxial names its confinement.
std::string test_title(const RunHeader& header);

/// "peak", or for a run without one "largest stress".
std::string peak_words(const RunData& run);

}  // namespace graincrack
