// Files that come with the programs and are named without a folder: materials, phases, loading programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace graincrack {

/// A folder of such files, and what they are to a user.
struct SharedFolder {
    std::string what;        ///< as messages name one of its files, "material"
    std::string folder;      ///< below share/, "materials"
    const char* variable{};  ///< environment variable with a folder of the user's own, looked into first; or null
    /// In the order in which a name is looked up: the user's own, and that of the installation, which is found relative to the
    /// program so that it may be moved.
    [[nodiscard]] std::vector<std::filesystem::path> places() const;
    /// The file that a name or a path means: a path has a slash or ends in .toml, or it is a file; a name is NAME.toml in one of
    /// `places`. A path need not exist. \throws InputError for an unknown name, with the known ones
    [[nodiscard]] std::filesystem::path find(const std::string& name_or_file) const;
    /// The files NAME.toml of a folder below `places`, "kinds", "" for theirs: in the order of `places`.
    [[nodiscard]] std::vector<std::filesystem::path> files_in(const std::string& folder_below) const;
    /// The file at a path below the first of `places` that has one there, "kinds/granite.toml"; empty if none has.
    [[nodiscard]] std::filesystem::path below(const std::string& path) const;
};

/// share/materials and $GRAINCRACK_MATERIALS.
const SharedFolder& materials();
/// share/programs.
const SharedFolder& loading_programs();

}  // namespace graincrack
