// PNGs of tests, by libpng.
#pragma once

#include <png.h>
#include <zlib.h>

#include <string>
#include <vector>

namespace graincrack::mesher {

/// What kind of PNG is written; `samples` of a pixel follow each other.
struct PngKind {
    int colour_type = PNG_COLOR_TYPE_GRAY;
    int bits = 8;
    bool interlaced = false;
    std::vector<png_color> palette = {};  ///< empty: shades of grey
};

/// The bytes of a PNG with such samples, row by row from the top; a palette has 256 shades of grey, of fewer bits as many as fit,
/// unless it is given.
inline std::string png_of(int width, int height, const std::vector<int>& samples, const PngKind& kind = {}) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const auto append = [](png_structp p, png_bytep data, std::size_t n) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(data), n);
    };
    png_set_write_fn(png, &bytes, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), kind.bits, kind.colour_type,
                 kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (kind.colour_type == PNG_COLOR_TYPE_PALETTE) {
        std::vector<png_color> palette = kind.palette;
        for (int i = 0; kind.palette.empty() && i < 1 << kind.bits; ++i) {
            const auto shade = static_cast<png_byte>(i);
            palette.push_back({shade, shade, shade});
        }
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    }
    png_write_info(png, info);
    png_set_packing(png);
    std::vector<png_byte> data;
    for (const int sample : samples) {
        if (kind.bits == 16) data.push_back(static_cast<png_byte>(sample >> 8));
        data.push_back(static_cast<png_byte>(sample & 0xff));
    }
    const std::size_t row_bytes = data.size() / static_cast<std::size_t>(height);
    std::vector<png_bytep> rows;
    for (std::size_t at = 0; at < data.size(); at += row_bytes) rows.push_back(data.data() + at);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

}  // namespace graincrack::mesher
