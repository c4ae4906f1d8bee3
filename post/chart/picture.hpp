// Drawings to files: PNG, SVG or PDF (Cairo), whole or not at all.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack {

/// How large a picture is on paper.
struct PictureSize {
    /// m. Without it a pixel of the drawing is one of a PNG or SVG, and a PDF is `pdf_width` wide.
    std::optional<double> width;
    /// Pixels of a PNG to an inch; 300 unless given. Needs a width.
    std::optional<double> resolution;
};
/// Width of a page's two columns in most journals, m.
inline constexpr double pdf_width = 0.174;

/// Checks name and size of a picture, before the work of drawing it.
/// \throws UsageError if the name ends in none of .png, .svg, .pdf, or the resolution has no meaning for it
void require_picture(const std::string& path, const PictureSize& size);

/// Writes a drawing as the kind of file its name asks for.
/// \throws UsageError for another ending, OutputError if it cannot be drawn or written
void write_picture(const Drawing& drawing, const std::string& path, const PictureSize& size = {});

/// A drawing as the bytes of a PNG file, which says its resolution if it has a width on paper. \throws OutputError if it cannot
/// be drawn
std::vector<unsigned char> png_bytes(const Drawing& drawing, const PictureSize& size = {});

/// A drawing as an SVG document. Its letters are outlines; its texts are in the document's description too, for search and for
/// those who do not see. \throws OutputError if it cannot be drawn
std::string to_svg(const Drawing& drawing, const PictureSize& size = {});

/// "cairo 1.16.0".
std::string cairo_library_version();

}  // namespace graincrack
