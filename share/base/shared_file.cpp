#include "share/base/shared_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <set>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace fs = std::filesystem;

std::vector<fs::path> SharedFolder::places() const {
    std::vector<fs::path> folders;
    const char* own = variable != nullptr ? std::getenv(variable) : nullptr;
    if (own != nullptr && *own != '\0') folders.emplace_back(own);
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
    if (!unknown) folders.push_back((program.parent_path() / GRAINCRACK_SHARE_FROM_PROGRAM / folder).lexically_normal());
    return folders;
}

fs::path SharedFolder::find(const std::string& name_or_file) const {
    std::error_code ignored;
    fs::path path(name_or_file);
    if (name_or_file.find('/') != std::string::npos || path.extension() == ".toml" || fs::is_regular_file(path, ignored)) {
        return path;
    }
    if (fs::path file = below(name_or_file + ".toml"); !file.empty()) return file;
    std::set<std::string> names;
    std::vector<std::string> looked_in;
    for (const fs::path& file : files_in("")) names.insert(file.stem().string());
    for (const fs::path& place : places()) looked_in.push_back(place.string());
    const std::vector<std::string> known(names.begin(), names.end());
    throw InputError(fmt::format("{} {}: not found{}; known are {} (looked in {}); a path to a TOML file fits too", what,
                                 name_or_file, did_you_mean(name_or_file, known),
                                 known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", ")), fmt::join(looked_in, ", ")));
}

std::vector<fs::path> SharedFolder::files_in(const std::string& folder_below) const {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (const fs::path& place : places()) {
        for (fs::directory_iterator entry(place / folder_below, ignored); entry != fs::directory_iterator();
             entry.increment(ignored)) {
            if (ignored) break;
            if (entry->path().extension() == ".toml") files.push_back(entry->path());
        }
    }
    return files;
}

fs::path SharedFolder::below(const std::string& path) const {
    std::error_code ignored;
    for (const fs::path& place : places()) {
        if (fs::is_regular_file(place / path, ignored)) return place / path;
    }
    return {};
}

const SharedFolder& materials() {
    static const SharedFolder folder{"material", "materials", "GRAINCRACK_MATERIALS"};
    return folder;
}

const SharedFolder& loading_programs() {
    static const SharedFolder folder{"program", "programs"};
    return folder;
}

}  // namespace graincrack
