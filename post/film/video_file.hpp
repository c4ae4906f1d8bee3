// Pictures one after the other as a video file, which the program ffmpeg encodes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture.hpp"
#include "post/film/child_process.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {

/// How a film runs.
struct FilmForm {
    ImageSize size{1280, 720};
    int frames_per_second = 25;
};

/// What becomes of the pictures of a film. Without a commit nothing is left.
class FilmOutput {
public:
    virtual ~FilmOutput() = default;
    /// \throws OutputError
    virtual void add(const Drawing& picture) = 0;
    virtual void commit() = 0;
};

/// The names of the encoders that ffmpeg has; empty without ffmpeg. \throws OutputError if it fails
std::vector<std::string> ffmpeg_encoders();

/// How a file is encoded: H.264 for .mp4, or MPEG-4 where ffmpeg lacks it; VP9 for .webm. \throws OutputError if ffmpeg has no
/// such encoder
std::vector<std::string> encoding_of(const std::string& path, const std::vector<std::string>& encoders);

/// A file in .mp4 or .webm.
class VideoFile : public FilmOutput {
public:
    /// \throws OutputError, UsageError as `OutputFile`, UsageError for what is no file
    VideoFile(const std::string& path, const FilmForm& form, const std::vector<std::string>& encoders);
    void add(const Drawing& picture) override;
    void commit() override;

private:
    /// Waits for ffmpeg. \throws OutputError with what it printed, if it failed
    void finish();

    OutputFile file_;
    FilmForm form_;
    std::unique_ptr<ChildProcess> ffmpeg_;
};

}  // namespace graincrack
