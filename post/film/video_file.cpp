#include "post/film/video_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "share/base/error.hpp"

namespace graincrack {

namespace {

/// The last line of a text that says something; the first lines of ffmpeg's errors are often only where they happened.
std::string last_line(const std::string& text) {
    std::istringstream lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
    }
    return last;
}

[[noreturn]] void fail(const std::string& name, int code, const std::string& errors) {
    const std::string said = last_line(errors);
    throw OutputError(fmt::format("{}: ffmpeg ended with exit code {}{}", name, code, said.empty() ? "" : ": " + said));
}

}  // namespace

std::vector<std::string> ffmpeg_encoders() {
    const std::unique_ptr<ChildProcess> ffmpeg =
        ChildProcess::start({"ffmpeg", "-hide_banner", "-loglevel", "error", "-encoders"});
    if (!ffmpeg) return {};
    const int code = ffmpeg->wait();
    if (code != 0) fail("list of encoders", code, ffmpeg->errors());
    std::vector<std::string> names;
    std::istringstream lines(ffmpeg->output());
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string flags;
        std::string name;
        if (words >> flags >> name) names.push_back(name);
    }
    return names;
}

std::vector<std::string> encoding_of(const std::string& path, const std::vector<std::string>& encoders) {
    const auto has = [&](const char* name) { return std::find(encoders.begin(), encoders.end(), name) != encoders.end(); };
    if (path.ends_with(".webm")) {
        if (!has("libvpx-vp9")) throw OutputError(path + ": ffmpeg has no encoder for VP9 (libvpx-vp9); name a file in .mp4");
        return {"-c:v",      "libvpx-vp9", "-crf",    "32", "-b:v",     "0",       "-deadline", "good",
                "-cpu-used", "4",          "-row-mt", "1",  "-pix_fmt", "yuv420p", "-f",        "webm"};
    }
    const std::vector<std::string> mp4{"-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4"};
    std::vector<std::string> words;
    if (has("libx264")) {
        words = {"-c:v", "libx264", "-preset", "medium", "-crf", "20"};
    } else if (has("mpeg4")) {
        words = {"-c:v", "mpeg4", "-q:v", "3"};
    } else {
        throw OutputError(path + ": ffmpeg has no encoder for H.264 (libx264) or MPEG-4 (mpeg4); name a folder of pictures");
    }
    words.insert(words.end(), mp4.begin(), mp4.end());
    return words;
}

VideoFile::VideoFile(const std::string& path, const FilmForm& form, const std::vector<std::string>& encoders)
    : file_(path), form_(form) {
    if (file_.is_stream()) throw UsageError(path + ": is no file; a film is written into a file or a folder");
    require_no_hdf5(file_);
    const std::vector<std::string> encoding = encoding_of(path, encoders);
    std::vector<std::string> words{"ffmpeg",
                                   "-hide_banner",
                                   "-loglevel",
                                   "error",
                                   "-y",
                                   "-f",
                                   "rawvideo",
                                   "-pixel_format",
                                   "rgb24",
                                   "-video_size",
                                   fmt::format("{}x{}", form.size.width, form.size.height),
                                   "-framerate",
                                   std::to_string(form.frames_per_second),
                                   "-i",
                                   "pipe:0",
                                   "-fflags",
                                   "+bitexact"};
    // Of HDTV, which players take for granted in videos of this size, and says so.
    for (const char* word : {"-vf", "scale=out_color_matrix=bt709", "-colorspace", "bt709", "-color_primaries", "bt709",
                             "-color_trc", "bt709", "-color_range", "tv"}) {
        words.emplace_back(word);
    }
    words.insert(words.end(), encoding.begin(), encoding.end());
    words.push_back("file:" + file_.begin());
    ffmpeg_ = ChildProcess::start(words);
    if (!ffmpeg_) throw OutputError(path + ": ffmpeg cannot be started");
}

void VideoFile::finish() {
    const int code = ffmpeg_->wait();
    if (code != 0) fail(file_.name(), code, ffmpeg_->errors());
}

void VideoFile::add(const Drawing& picture) {
    if (ffmpeg_->write(rgb_image(picture, form_.size))) return;
    finish();
    throw OutputError(file_.name() + ": ffmpeg took no more pictures");
}

void VideoFile::commit() {
    finish();
    file_.commit();
}

}  // namespace graincrack
