// Writes drawings to PNG, SVG or PDF files with Cairo, completely or not at all.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack {

/// Size of a picture on paper.
struct PictureSize {
    /// Width, m. Without it a pixel of the drawing is one of a PNG or SVG, and a PDF has the width `pdf_width`.
    std::optional<double> width;
    /// Pixels per inch of a PNG, 300 by default; it needs a width.
    std::optional<double> resolution;
};
/// Width of a two-column page of most journals, m.
inline constexpr double pdf_width = 0.174;

/// Checks name and size of a picture before it is drawn.
/// \throws UsageError if the name ends in none of .png, .svg, .pdf, or the resolution has no meaning for it
void require_picture(const std::string& path, const PictureSize& size);

/// Writes a drawing as the kind of file of its ending.
/// \throws UsageError for another ending, OutputError if it cannot be drawn or written
void write_picture(const Drawing& drawing, const std::string& path, const PictureSize& size = {});

/// Returns a drawing as the bytes of a PNG file, with its resolution if it has a width on paper. \throws OutputError if it cannot
/// be drawn
std::vector<unsigned char> png_bytes(const Drawing& drawing, const PictureSize& size = {});

/// Returns a drawing as an SVG document. Letters are outlines; the description of the document has the texts, for search and for
/// readers who do not see. \throws OutputError if it cannot be drawn
std::string to_svg(const Drawing& drawing, const PictureSize& size = {});

/// Version of the library: "cairo 1.16.0".
std::string cairo_library_version();

}  // namespace graincrack
