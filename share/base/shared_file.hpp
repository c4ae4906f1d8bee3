// Finds files that come with the programs and are named without a folder: materials, phases, loading programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace graincrack {

/// A folder of such files.
struct SharedFolder {
    std::string what;        ///< what messages call one of its files: "material"
    std::string folder;      ///< folder below share/, "materials"
    const char* variable{};  ///< environment variable with a user folder that is searched first; or null
    /// Folders in search order: that of the user and that of the installation, which is found relative to the program so that it
    /// may be moved.
    [[nodiscard]] std::vector<std::filesystem::path> places() const;
    /// Finds the file of a name or a path. A text with a slash or the ending .toml, or that names a file, is a path, which need
    /// not exist. A name is NAME.toml in one of `places`. \throws InputError for an unknown name, listing the known names
    [[nodiscard]] std::filesystem::path find(const std::string& name_or_file) const;
    /// The files NAME.toml of a folder below `places`, such as "kinds" ("": `places` themselves), in the order of `places`.
    [[nodiscard]] std::vector<std::filesystem::path> files_in(const std::string& folder_below) const;
    /// The file at a path such as "kinds/granite.toml" below the first of `places` that has it; empty if none has.
    [[nodiscard]] std::filesystem::path below(const std::string& path) const;
};

/// The folder share/materials, with $GRAINCRACK_MATERIALS.
const SharedFolder& materials();
/// The folder share/programs.
const SharedFolder& loading_programs();

}  // namespace graincrack
