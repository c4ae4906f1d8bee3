#include "post/film/picture_folder.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/progress.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view stem = "frame_";
constexpr std::string_view ending = ".png";

bool is_picture_of_film(const std::string& name) {
    if (!name.starts_with(stem) || !name.ends_with(ending) || name.size() < stem.size() + ending.size() + 4) return false;
    const std::string_view number = std::string_view(name).substr(stem.size(), name.size() - stem.size() - ending.size());
    return std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The path of a folder that may not exist yet. \throws OutputError without a folder around it
std::string whole_path(const std::string& name) {
    std::error_code cause;
    fs::path path = fs::weakly_canonical(fs::absolute(name), cause);
    if (cause) throw OutputError(fmt::format("{}: cannot be written: {}", name, cause.message()));
    if (!path.has_filename()) path = path.parent_path();  // "film/"
    if (!fs::is_directory(path.parent_path(), cause)) {
        throw OutputError(fmt::format("{}: the folder {} does not exist", name, path.parent_path().string()));
    }
    return path.string();
}

/// \throws OutputError for what exists and is not an empty folder or one of pictures of a film
void require_own(const std::string& name, const std::string& folder) {
    std::error_code cause;
    const fs::file_type type = fs::status(folder, cause).type();
    if (type == fs::file_type::not_found) return;
    if (type != fs::file_type::directory) throw OutputError(name + ": exists, and is no folder; name a folder, .mp4 or .webm");
    for (fs::directory_iterator each(folder, cause), end; !cause && each != end; each.increment(cause)) {
        const std::string file = each->path().filename().string();
        if (is_picture_of_film(file)) continue;
        throw OutputError(fmt::format("{}: has {}, which is no picture of a film; name a new or an empty folder", name, file));
    }
    if (cause) throw OutputError(fmt::format("{}: cannot be read: {}", name, cause.message()));
}

/// A word of a command line of a shell.
std::string shell_word(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

}  // namespace

PictureFolder::PictureFolder(const std::string& path, ImageSize size, std::size_t count)
    : name_(path),
      folder_(whole_path(path)),
      part_(folder_ + ".part"),
      lock_(folder_),
      size_(size),
      digits_(std::max(4, static_cast<int>(std::to_string(count).size()))) {
    require_own(name_, folder_);
    require_own(name_ + ".part", part_);  // of a program that was killed
    std::error_code cause;
    fs::remove_all(part_, cause);
    if (!fs::create_directory(part_, cause)) throw OutputError(fmt::format("{}: cannot be made: {}", name_, cause.message()));
}

PictureFolder::~PictureFolder() {
    std::error_code cause;
    fs::remove_all(part_, cause);
}

void PictureFolder::add(const Drawing& picture) {
    const std::vector<unsigned char> bytes = png_image(picture, size_);
    const std::string name = fmt::format("{}{:0{}}{}", stem, next_++, digits_, ending);
    const std::unique_ptr<OutputFile> file = OutputFile::covered(part_ + "/" + name);
    file->begin();
    file->write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    file->commit();
}

void PictureFolder::commit() {
    require_own(name_, folder_);
    std::error_code cause;
    fs::remove_all(folder_, cause);
    if (!cause) fs::rename(part_, folder_, cause);
    if (cause) throw OutputError(fmt::format("{}: cannot be written: {}", name_, cause.message()));
    add_output_to_outcome(name_);
}

bool has_ffmpeg() { return std::system("command -v ffmpeg >/dev/null 2>&1") == 0; }

void PictureFolder::join(int frames_per_second, const std::string& kind, const std::string& file,
                         const std::string& video) const {
    std::string pictures;
    for (const char c : part_) pictures += c == '%' ? std::string("%%") : std::string(1, c);
    // The colours are those of HDTV, which players take for granted in videos of this size.
    const std::string command = fmt::format(
        "ffmpeg -nostdin -hide_banner -loglevel error -y -framerate {} -i {} -vf scale=out_color_matrix=bt709 -colorspace bt709 "
        "-color_primaries bt709 -color_trc bt709 -color_range tv -pix_fmt yuv420p {} -f {} {}",
        frames_per_second, shell_word(fmt::format("{}/{}%0{}d{}", pictures, stem, digits_, ending)),
        kind == "webm" ? "-crf 32 -b:v 0 -cpu-used 4" : "-movflags +faststart", kind, shell_word("file:" + file));
    FILE* const ffmpeg = ::popen((command + " 2>&1").c_str(), "r");
    if (ffmpeg == nullptr) throw OutputError(video + ": ffmpeg cannot be started");
    std::string last;
    std::array<char, 1000> line{};
    while (std::fgets(line.data(), line.size(), ffmpeg) != nullptr) {
        if (line[0] != '\n') last = std::string(": ") + line.data();
    }
    const int status = ::pclose(ffmpeg);
    throw_if_interrupted();
    if (status == 0) return;
    while (last.ends_with('\n')) last.pop_back();
    throw OutputError(fmt::format("{}: ffmpeg ended with exit code {}{}", video, WEXITSTATUS(status), last));
}

}  // namespace graincrack
