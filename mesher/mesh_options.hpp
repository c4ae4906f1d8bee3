// Reads the command line of graincrack-mesh.
#pragma once

#include <optional>
#include <string>

#include "mesher/import/import_specimen.hpp"
#include "mesher/mesh.hpp"
#include "share/rock/material.hpp"

namespace graincrack::mesher {

/// The options of a call.
struct MeshOptions {
    Request request;
    std::optional<ImportRequest> imported;  ///< imported mesh; the request has its fabric and seed
    std::string material_name;              ///< name as given
    std::optional<Material> material;       ///< its fabric provides the defaults of the request
    std::string output;                     ///< file or "-"
    Point moved;                            ///< translation of a polygon to the origin, m
    Verbosity verbosity = Verbosity::normal;
    bool dry_run = false;
    std::string configuration;  ///< options in use as TOML
    Settings settings;          ///< values in use, for the file
};

/// Reads the command line. \return empty after --help, --version or --print-config, which are answered
/// \throws UsageError
std::optional<MeshOptions> read_options(int argc, const char* const* argv);

}  // namespace graincrack::mesher
