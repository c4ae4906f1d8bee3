// The command line of graincrack-mesh.
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
    std::optional<ImportRequest> imported;  ///< a mesh from elsewhere, of which the request has the fabric and the seed
    std::string material_name;              ///< as it was given
    std::optional<Material> material;       ///< whose fabric the request has where no option says otherwise
    std::string output;                     ///< file or "-"
    Point moved;                            ///< translation of a polygon to the origin, m
    Verbosity verbosity = Verbosity::normal;
    bool dry_run = false;
    std::string configuration;  ///< effective options as TOML
    Settings settings;          ///< their effective values, for the file
};

/// Reads the command line. \return nothing after --help, --version or --print-config, which were answered
/// \throws UsageError
std::optional<MeshOptions> read_options(int argc, const char* const* argv);

}  // namespace graincrack::mesher
