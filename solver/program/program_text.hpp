// Writing of loading programs.
#pragma once

#include <string>

#include "solver/program/program.hpp"

namespace graincrack {

/// The program as its file: reading that gives the same program, number by number. Values are in SI units.
std::string program_text(const Program& program);

}  // namespace graincrack
