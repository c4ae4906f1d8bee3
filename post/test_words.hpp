// Words for tests and states in titles.
#pragma once

#include <string>

#include "share/run_file.hpp"

namespace graincrack {

/// "Uniaxial compression, Augig granite"; triaxial names its confinement.
std::string test_title(const RunHeader& header);

}  // namespace graincrack
