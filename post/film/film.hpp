// A film of a test, as a video or as a folder of pictures.
#pragma once

#include <string>

#include "post/film/film_page.hpp"
#include "post/options/command.hpp"

namespace graincrack {

struct FilmOptions {
    std::string output;  ///< .mp4, .webm or a folder
    FilmContents contents;
    double duration = 10;  ///< s
    int frames_per_second = 25;
};

/// Reads "1280x720". \throws UsageError for odd numbers, which videos cannot have, and for pages that have no room for map and
/// charts
ImageSize parse_film_size(const std::string& text);

/// True if a name is that of a video; otherwise it is a folder. \throws UsageError for another ending, and for "-"
bool is_video_name(const std::string& output);

/// How many pictures a film has. \throws UsageError for fewer than two
std::size_t n_pictures(double duration, int frames_per_second);

/// Makes the film of a run. \throws InputError, UsageError as `FilmPage`, OutputError, also where a video is requested and there
/// is no ffmpeg; Interrupted
void make_film(const FilmOptions& options, const Call& call);

}  // namespace graincrack
