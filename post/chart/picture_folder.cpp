#include "post/chart/picture_folder.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <regex>
#include <system_error>

#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {

namespace fs = std::filesystem;

namespace {

/// The absolute path of a folder that may not exist yet. \throws OutputError without a parent folder
std::string whole_path(const std::string& name) {
    std::error_code cause;
    fs::path path = fs::weakly_canonical(fs::absolute(name), cause);
    if (cause) throw OutputError(fmt::format("{}: cannot be written: {}", name, cause.message()));
    if (!path.has_filename()) path = path.parent_path();  // for "film/"
    if (!fs::is_directory(path.parent_path(), cause)) {
        throw OutputError(fmt::format("{}: the folder {} does not exist", name, path.parent_path().string()));
    }
    return path.string();
}

/// Checks what is at the path of the folder. \throws OutputError unless it is missing, empty or has numbered pictures only
void require_own(const std::string& name, const std::string& folder) {
    std::error_code cause;
    const fs::file_type type = fs::status(folder, cause).type();
    if (type == fs::file_type::not_found) return;
    if (type != fs::file_type::directory) throw OutputError(name + ": exists, and is no folder; name a new folder");
    static const std::regex numbered(R"(frame-\d{4,}\.png)");
    for (fs::directory_iterator each(folder, cause), end; !cause && each != end; each.increment(cause)) {
        const std::string file = each->path().filename().string();
        if (std::regex_match(file, numbered)) continue;
        throw OutputError(fmt::format("{}: has {}, which is no numbered picture; name a new or an empty folder", name, file));
    }
    if (cause) throw OutputError(fmt::format("{}: cannot be read: {}", name, cause.message()));
}

}  // namespace

void write_picture_folder(const std::string& folder, std::size_t count,
                          const std::function<std::vector<unsigned char>(std::size_t)>& picture) {
    const std::string whole = whole_path(folder);
    const OutputLock lock(whole);
    require_own(folder, whole);
    require_own(folder + ".part", whole + ".part");  // left by a program that was killed
    const std::string part = whole + ".part";
    std::error_code cause;
    fs::remove_all(part, cause);
    const std::shared_ptr<void> unfinished(nullptr, [&](void* /*none*/) { fs::remove_all(part, cause); });  // none if renamed
    if (!fs::create_directory(part, cause)) throw OutputError(fmt::format("{}: cannot be made: {}", folder, cause.message()));
    for (std::size_t i = 0; i < count; ++i) {
        throw_if_interrupted();
        const std::vector<unsigned char> bytes = picture(i);
        const auto file = OutputFile::covered(fmt::format("{}/frame-{:04}.png", part, i + 1));
        file->begin();
        file->write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        file->commit();
    }
    throw_if_interrupted();
    require_own(folder, whole);
    fs::remove_all(whole, cause);
    if (!cause) fs::rename(part, whole, cause);
    if (cause) throw OutputError(fmt::format("{}: cannot be written: {}", folder, cause.message()));
    add_output_to_outcome(folder);
}

}  // namespace graincrack
