// Provenance of a file: tool, version, commit, command line, libraries, time. The digest leaves it out.
#pragma once

#include <string>
#include <vector>

namespace graincrack {

class H5Output;

/// Version of the project ("0.1.0").
std::string project_version();
/// Commit from which the project was built, "" if unknown.
std::string project_commit();
/// Versions of the libraries of this build, "HDF5 1.10.8" and the like; programs add their own (CGAL, VTK, …).
std::vector<std::string> library_versions();

/// The content of /provenance.
struct Provenance {
    std::string tool;
    std::vector<std::string> command_line;
    std::string configuration;  ///< effective options as TOML
    std::string material;       ///< as spelt on the command line, "" if none
    std::string input_digest;   ///< digest of the input file, "" if none
    std::vector<std::string> libraries;
    double wall_time = 0;  ///< s
    int threads = 1;       ///< threads per rank
    int ranks = 1;
    std::string vector_target;  ///< instructions used by the kernels of a run; all give the same content
};

/// Writes /provenance, with host name and UTC time.
void write_provenance(H5Output& file, const Provenance& provenance);

}  // namespace graincrack
