// Numbered pictures in a folder, which appears whole or not at all.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace graincrack {

/// Writes frame-0001.png, … in FOLDER.part, which then takes the place of the folder. A call that fails leaves nothing.
/// \param picture the bytes of a PNG by its number from 0
/// \throws OutputError for a file, for a folder that holds other things, and without a folder around it; Interrupted
void write_picture_folder(const std::string& folder, std::size_t count,
                          const std::function<std::vector<unsigned char>(std::size_t)>& picture);

}  // namespace graincrack
