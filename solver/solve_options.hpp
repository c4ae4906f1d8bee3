// The command line of graincrack-solve.
#pragma once

#include <optional>
#include <string>

#include "solver/setup/request.hpp"

namespace graincrack {

struct SolveOptions {
    SimulationRequest request;
    std::string specimen;  ///< file or "-"
    std::string output;    ///< file or "-"
    Verbosity verbosity = Verbosity::normal;
    bool dry_run = false;
    bool print_program = false;  ///< print the program that a standard test is, and run nothing
    std::string configuration;   ///< effective options as TOML
    std::string material;        ///< as it was given
};

/// Reads options, configuration and material; empty if the call was answered (--help, --version, --print-config).
/// \throws UsageError, InputError
std::optional<SolveOptions> read_solve_options(int argc, char** argv);

}  // namespace graincrack
