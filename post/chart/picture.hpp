// Drawings to files: PNG (VTK, no display needed) or SVG, whole or not at all.
#pragma once

#include <string>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack {

/// Checks the file name of a picture, before the work of drawing it.
/// \throws UsageError if it ends neither in .png nor in .svg
void require_picture_name(const std::string& path);

/// Writes a drawing as the kind of file its name asks for.
/// \throws UsageError for another ending, OutputError if it cannot be drawn or written
void write_picture(const Drawing& drawing, const std::string& path);

/// A drawing as the bytes of a PNG file. \throws OutputError if it cannot be drawn
std::vector<unsigned char> png_bytes(const Drawing& drawing);

/// "VTK 9.1.0".
std::string vtk_library_version();

}  // namespace graincrack
