// The command line of graincrack-mesh.
#pragma once

#include <optional>
#include <string>

#include "mesher/specimen_maker.hpp"
#include "share/progress.hpp"

namespace graincrack::mesher {

/// What the command line asks for.
struct MeshOptions {
    SpecimenRequest request;
    std::string material;  ///< name or file for the size checks; empty without
    std::string output;    ///< file or "-"
    Verbosity verbosity = Verbosity::normal;
    bool dry_run = false;
    std::string configuration;  ///< effective options as TOML
};

/// Reads the command line. \return nothing if the call was answered already (--help, --version, --print-config)
/// \throws UsageError
std::optional<MeshOptions> read_options(int argc, const char* const* argv);

}  // namespace graincrack::mesher
