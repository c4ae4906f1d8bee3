// Pictures one after the other as numbered PNG files of a folder, and the call of ffmpeg that joins them in a video.
#pragma once

#include <cstddef>
#include <string>

#include "post/chart/drawing.hpp"
#include "post/chart/picture.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {

/// frame_0001.png, … . They are written in FOLDER.part, which then becomes the folder, or whose files move into the folder if
/// there is one. Without a commit nothing is left.
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

    /// The folder that the pictures are in until the commit.
    [[nodiscard]] const std::string& part() const { return part_; }
    /// The names of the pictures as ffmpeg takes them, "frame_%04d.png".
    [[nodiscard]] std::string pattern() const;

private:
    std::string name_;    ///< as it was given
    std::string folder_;  ///< its whole path
    std::string part_;
    OutputLock lock_;
    ImageSize size_;
    int digits_;
    std::size_t next_ = 1;
};

/// The command line of a shell that joins the pictures of a folder in a video. \param kind "mp4" or "webm"
std::string joining_command(const std::string& folder, const std::string& pattern, int frames_per_second, const std::string& kind,
                            const std::string& video);

/// True if the program ffmpeg is on the PATH.
bool has_ffmpeg();

/// Calls ffmpeg. \param video its name in messages \throws OutputError with the last line that ffmpeg printed, if it failed;
/// Interrupted
void join_pictures(const std::string& command, const std::string& video);

}  // namespace graincrack
