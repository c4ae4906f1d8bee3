// Writes numbered pictures into a folder, which appears completely or not at all.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace graincrack {

/// Writes frame-0001.png, … in FOLDER.part, which then replaces the folder. A failed call leaves nothing.
/// \param picture returns the bytes of a PNG by its number from 0
/// \throws OutputError for a file, a folder with other content, or a missing parent folder; Interrupted
void write_picture_folder(const std::string& folder, std::size_t count,
                          const std::function<std::vector<unsigned char>(std::size_t)>& picture);

}  // namespace graincrack
