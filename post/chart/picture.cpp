#include "post/chart/picture.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>
#include <zlib.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <span>

#include "post/chart/font.hpp"
#include "share/base/error.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {

namespace {

constexpr double metres_per_inch = 0.0254;
constexpr double points_per_inch = 72;
constexpr double default_resolution = 300;
constexpr int max_pixels = 32767;  ///< along a side of a Cairo image

struct FreeCairo {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, FreeCairo>;

std::string ending(const std::string& path) { return std::filesystem::path(path).extension().string(); }

void require(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS) {
        throw OutputError(fmt::format("picture: could not be made: {}", cairo_status_to_string(status)));
    }
}

/// Lengths of alternating strokes and gaps; round ends lengthen a stroke by the width of the line.
std::vector<double> pattern_of(Dash dash, double width) {
    const double gap = 8 + 1.4 * width;
    switch (dash) {
        case Dash::none: return {};
        case Dash::dashed: return {14, gap};
        case Dash::dotted: return {0.1, 0.6 * gap + 2};
        case Dash::dash_dot: return {18, gap, 0.1, gap};
        case Dash::long_dashed: return {34, gap};
    }
    return {};
}

/// Draws shapes in units of pixels of the drawing.
class Painter {
public:
    explicit Painter(cairo_t* context) : context_(context) {
        cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    }
    void operator()(const Polygons& polygons) {
        set_colour(polygons.fill);
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            add_path(polygons[i]);
            cairo_close_path(context_);
            if (i % shapes_per_path == shapes_per_path - 1) cairo_fill(context_);
        }
        cairo_fill(context_);
    }
    void operator()(const Strokes& strokes) {
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            add_path(std::span(strokes.ends).subspan(2 * i, 2));
            if (i % shapes_per_path == shapes_per_path - 1) stroke(strokes.width, strokes.colour);
        }
        stroke(strokes.width, strokes.colour);
    }
    void operator()(const Polyline& line) {
        add_path(line.points);
        const std::vector<double> pattern = pattern_of(line.dash, line.width);
        cairo_set_dash(context_, pattern.data(), static_cast<int>(pattern.size()), 0);
        stroke(line.width, line.colour);
        cairo_set_dash(context_, nullptr, 0, 0);
    }
    void operator()(const Text& text) { show_text(context_, text); }

private:
    void set_colour(Colour c) { cairo_set_source_rgb(context_, c.red / 255.0, c.green / 255.0, c.blue / 255.0); }
    void add_path(std::span<const Pixel> points) {
        cairo_new_sub_path(context_);
        for (const Pixel& p : points) cairo_line_to(context_, p.x, p.y);
    }
    void stroke(double width, Colour colour) {
        set_colour(colour);
        cairo_set_line_width(context_, width);
        cairo_stroke(context_);
    }
    static constexpr std::size_t shapes_per_path = 4096;  ///< bounds the memory of a path
    cairo_t* context_;
};

/// Draws all shapes on white. \param scale units of the surface per pixel of the drawing
void paint(const Drawing& drawing, cairo_surface_t* surface, double scale) {
    const std::unique_ptr<cairo_t, FreeCairo> context(cairo_create(surface));
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());
    cairo_scale(context.get(), scale, scale);
    Painter painter(context.get());
    for (const Drawing::Shape& shape : drawing.shapes()) std::visit(painter, shape);
    require(cairo_status(context.get()));
}

template <class Bytes>
cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size) {
    auto& all = *static_cast<Bytes*>(bytes);
    all.insert(all.end(), data, data + size);
    return CAIRO_STATUS_SUCCESS;
}

/// Paints on a surface whose bytes are complete afterwards.
void paint_whole(const Drawing& drawing, const Surface& surface, double scale) {
    paint(drawing, surface.get(), scale);
    cairo_surface_finish(surface.get());
    require(cairo_surface_status(surface.get()));
}

/// Points of a page per pixel of the drawing.
double points_per_pixel(const Drawing& drawing, double width) {
    return width / metres_per_inch * points_per_inch / drawing.width();
}

std::string to_pdf(const Drawing& drawing, const PictureSize& size) {
    std::string bytes;
    const double scale = points_per_pixel(drawing, size.width.value_or(pdf_width));
    const Surface surface(
        cairo_pdf_surface_create_for_stream(&append<std::string>, &bytes, scale * drawing.width(), scale * drawing.height()));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");  // the same bytes on every day
    paint_whole(drawing, surface, scale);
    return bytes;
}

/// Appends the most significant byte first, as PNG requires.
void append_big_endian(std::vector<unsigned char>& bytes, std::uint32_t value) {
    for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes.push_back(static_cast<unsigned char>(value >> shift));
}

/// Writes the resolution into a PNG, as a chunk pHYs after the header (W3C PNG specification, 11.3.4.3).
void insert_resolution(std::vector<unsigned char>& png, double pixels_per_inch) {
    constexpr std::ptrdiff_t end_of_header = 8 + 25;  // signature, IHDR
    constexpr std::uint32_t size = 9;
    constexpr unsigned char unit_is_metre = 1;
    const auto per_metre = static_cast<std::uint32_t>(std::lround(pixels_per_inch / metres_per_inch));
    std::vector<unsigned char> chunk{'p', 'H', 'Y', 's'};
    for (int axis = 0; axis < 2; ++axis) append_big_endian(chunk, per_metre);
    chunk.push_back(unit_is_metre);
    append_big_endian(chunk, static_cast<std::uint32_t>(crc32(0, chunk.data(), static_cast<uInt>(chunk.size()))));
    std::vector<unsigned char> length;
    append_big_endian(length, size);
    chunk.insert(chunk.begin(), length.begin(), length.end());
    png.insert(png.begin() + end_of_header, chunk.begin(), chunk.end());
}

std::vector<unsigned char> to_png(const Drawing& drawing, int width, int height, double scale) {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
    paint(drawing, surface.get(), scale);
    std::vector<unsigned char> bytes;
    require(cairo_surface_write_to_png_stream(surface.get(), &append<std::vector<unsigned char>>, &bytes));
    return bytes;
}

}  // namespace

std::vector<unsigned char> png_bytes(const Drawing& drawing, const PictureSize& size) {
    const double resolution = size.resolution.value_or(default_resolution);
    const double scale = size.width ? *size.width / metres_per_inch * resolution / drawing.width() : 1;
    const double width = std::round(scale * drawing.width());
    const double height = std::round(scale * drawing.height());
    if (!(std::max(width, height) <= max_pixels)) {
        throw OutputError(
            fmt::format("picture: {:.0f} x {:.0f} pixels are too many, at most {} along a side; a smaller --dpi fits", width,
                        height, max_pixels));
    }
    std::vector<unsigned char> bytes = to_png(drawing, static_cast<int>(width), static_cast<int>(height), scale);
    if (size.width) insert_resolution(bytes, resolution);
    return bytes;
}

std::string to_svg(const Drawing& drawing, const PictureSize& size) {
    std::string bytes;
    const double scale = size.width ? points_per_pixel(drawing, *size.width) : 1;
    const Surface surface(
        cairo_svg_surface_create_for_stream(&append<std::string>, &bytes, scale * drawing.width(), scale * drawing.height()));
    cairo_svg_surface_set_document_unit(surface.get(), size.width ? CAIRO_SVG_UNIT_PT : CAIRO_SVG_UNIT_PX);
    paint_whole(drawing, surface, scale);
    const std::size_t root = bytes.find('\n', bytes.find("<svg")) + 1;
    bytes.insert(root, "<desc>" + escape_xml(drawing.words()) + "</desc>\n");
    // Cairo numbers the surfaces of a process. Numbers are removed so that equal drawings have equal bytes.
    if (const std::size_t name = bytes.find("<g id=\"surface"); name != std::string::npos) {
        bytes.erase(name + 2, bytes.find('>', name) - name - 2);
    }
    return bytes;
}

void require_picture(const std::string& path, const PictureSize& size) {
    const std::string kind = ending(path);
    if (kind != ".png" && kind != ".svg" && kind != ".pdf") {
        throw UsageError("--output " + path + ": a picture's name must end in .png, .svg or .pdf");
    }
    if (size.resolution && kind != ".png") throw UsageError("--dpi: " + path + " has no pixels; leave it out");
    if (size.resolution && !size.width) throw UsageError("--dpi: needs the picture's width; --width 84mm fits");
}

void write_picture(const Drawing& drawing, const std::string& path, const PictureSize& size) {
    require_picture(path, size);
    if (ending(path) == ".svg") {
        write_whole_file(path, to_svg(drawing, size));
    } else if (ending(path) == ".pdf") {
        write_whole_file(path, to_pdf(drawing, size));
    } else {
        const std::vector<unsigned char> bytes = png_bytes(drawing, size);
        write_whole_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
}

std::string cairo_library_version() { return std::string("cairo ") + cairo_version_string(); }

}  // namespace graincrack
