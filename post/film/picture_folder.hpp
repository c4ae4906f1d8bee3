// Pictures one after the other as numbered PNG files of a folder.
#pragma once

#include <cstddef>
#include <string>

#include "post/film/video_file.hpp"
#include "share/file/output_lock.hpp"

namespace graincrack {

/// frame_0001.png, … . Written in FOLDER.part, which then becomes the folder, or whose files move into the folder if there is
/// one.
class PictureFolder : public FilmOutput {
public:
    /// \throws OutputError for a file, for a folder with other files than those of a film, and without a folder around it
    PictureFolder(const std::string& path, ImageSize size, std::size_t count);
    ~PictureFolder() override;
    PictureFolder(const PictureFolder&) = delete;
    PictureFolder& operator=(const PictureFolder&) = delete;
    void add(const Drawing& picture) override;
    void commit() override;

    /// The command that joins the pictures in a video.
    [[nodiscard]] std::string joining_command(const std::string& video, int frames_per_second) const;

private:
    std::string name_;    ///< as it was given
    std::string folder_;  ///< its whole path
    std::string part_;
    OutputLock lock_;
    ImageSize size_;
    int digits_;
    std::size_t next_ = 1;
};

}  // namespace graincrack
