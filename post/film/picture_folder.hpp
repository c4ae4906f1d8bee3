// Pictures one after the other as numbered PNG files of a folder, and the call of ffmpeg that joins them in a video.
#pragma once

#include <cstddef>
#include <string>

#include "post/chart/drawing.hpp"
#include "post/chart/picture.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {

/// frame_0001.png, … . They are written in FOLDER.part, which a commit puts in place of the folder. Without a commit nothing is
/// left.
class PictureFolder {
public:
    /// \throws OutputError for a file, for a folder with other files than those of a film, and without a folder around it
    PictureFolder(const std::string& path, ImageSize size, std::size_t count);
    ~PictureFolder();
    PictureFolder(const PictureFolder&) = delete;
    PictureFolder& operator=(const PictureFolder&) = delete;
    /// \throws OutputError
    void add(const Drawing& picture);
    void commit();

    /// Calls ffmpeg, which joins the pictures in a video. \param kind "mp4" or "webm" \param file to be written \param video its
    /// name in messages \throws OutputError with the last line that ffmpeg printed, if it failed; Interrupted
    void join(int frames_per_second, const std::string& kind, const std::string& file, const std::string& video) const;

private:
    std::string name_;    ///< as it was given
    std::string folder_;  ///< its whole path
    std::string part_;
    OutputLock lock_;
    ImageSize size_;
    int digits_;
    std::size_t next_ = 1;
};

/// True if the program ffmpeg is on the PATH.
bool has_ffmpeg();

}  // namespace graincrack
