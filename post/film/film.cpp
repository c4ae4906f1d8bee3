#include "post/film/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

#include "post/film/picture_folder.hpp"
#include "share/base/error.hpp"
#include "share/base/progress.hpp"
#include "share/file/output_file.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

namespace {

constexpr int smallest_side = 240;
constexpr int largest_side = 4096;

/// A whole number that fills a text; 0 for another text.
int whole_number(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? number : 0;
}

bool is_side(int pixels) { return pixels >= smallest_side && pixels <= largest_side && pixels % 2 == 0; }

void write_pictures(const RunReader& run, const FilmContents& contents, std::size_t count, PictureFolder& pictures,
                    Verbosity verbosity) {
    FilmPage page(run, contents);
    const std::vector<std::size_t> rows = page.rows(count);
    Progress progress("film", verbosity);
    for (std::size_t i = 0; i < count; ++i) {
        throw_if_interrupted();
        pictures.add(page.at(rows[i]));
        progress.update(static_cast<double>(i + 1) / static_cast<double>(count), fmt::format("picture {} of {}", i + 1, count));
    }
    throw_if_interrupted();
}

}  // namespace

ImageSize parse_film_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    const std::string_view all(text);
    const bool has_two = cross != std::string::npos;
    const ImageSize size{has_two ? whole_number(all.substr(0, cross)) : 0, has_two ? whole_number(all.substr(cross + 1)) : 0};
    if (!is_side(size.width) || !is_side(size.height)) {
        throw UsageError(fmt::format("--size {}: expected even numbers of pixels from {} to {}, such as 1280x720", text,
                                     smallest_side, largest_side));
    }
    const double shape = static_cast<double>(size.width) / size.height;
    if (shape < 1.3 || shape > 3) {
        throw UsageError(fmt::format("--size {}: a film is 1.3 to 3 times as wide as high; 1280x720 and 960x720 fit", text));
    }
    return size;
}

bool is_video_name(const std::string& output) {
    if (output == "-") throw UsageError("--output -: a film is written into a file or a folder, not to stdout");
    const std::string ending = std::filesystem::path(output).extension().string();
    if (ending == ".mp4" || ending == ".webm") return true;
    if (ending.empty() || ending == "." || std::filesystem::is_directory(output)) return false;
    throw UsageError(
        fmt::format("--output {}: a film's name must end in .mp4 or .webm; a name without ending, or with / behind it, is a "
                    "folder of pictures",
                    output));
}

std::size_t n_pictures(double duration, int frames_per_second) {
    const double n = std::round(duration * frames_per_second);
    if (n < 2) {
        throw UsageError(fmt::format("--duration {:g}s: at {} pictures per second a film has two pictures from {:g}s on",
                                     duration, frames_per_second, 2.0 / frames_per_second));
    }
    return static_cast<std::size_t>(n);
}

void make_film(const FilmOptions& options, const Call& call) {
    const bool is_video = is_video_name(options.output);
    const std::size_t count = n_pictures(options.duration, options.frames_per_second);
    if (is_video && !has_ffmpeg()) {
        throw OutputError(options.output +
                          ": there is no ffmpeg to make a video; name a folder for the pictures, or install ffmpeg");
    }
    const RunReader run(call.file());
    if (!is_video) {
        PictureFolder pictures(options.output, options.contents.size, count);
        write_pictures(run, options.contents, count, pictures, call.verbosity);
        return pictures.commit();
    }
    OutputFile video(options.output);
    if (video.is_stream()) throw UsageError(options.output + ": is no file; a film is written into a file or a folder");
    require_no_hdf5(video);
    PictureFolder pictures(options.output + ".pictures", options.contents.size, count);
    write_pictures(run, options.contents, count, pictures, call.verbosity);
    pictures.join(options.frames_per_second, options.output.ends_with(".webm") ? "webm" : "mp4", video.begin(), options.output);
    video.commit();
}

}  // namespace graincrack
