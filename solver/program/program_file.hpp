// Reads and writes loading programs.
#pragma once

#include <string>

#include "solver/program/program.hpp"

namespace graincrack {

/// Reads a program from a file. \throws InputError that names file, line and key, the error, and what is allowed
Program read_program(const std::string& file);
/// Reads a program from text. \param name of the file in messages \throws InputError as `read_program`
Program parse_program(const std::string& text, const std::string& name);
/// The text of a program file, in SI units. Reading it gives the same program with equal numbers.
std::string program_text(const Program& program);

}  // namespace graincrack
