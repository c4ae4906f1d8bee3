// Reading and writing of loading programs.
#pragma once

#include <string>

#include "solver/program/program.hpp"

namespace graincrack {

/// Reads a program. \throws InputError naming file, line and key, what is wrong, and what would be right
Program read_program(const std::string& file);
/// The same from text; `name` stands for the file in messages.
Program parse_program(const std::string& text, const std::string& name);
/// The program as its file: reading that gives the same program, number by number. Values are in SI units.
std::string program_text(const Program& program);

}  // namespace graincrack
