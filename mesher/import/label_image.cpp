#include "mesher/import/label_image.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csetjmp>
#include <cstring>
#include <limits>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// Reads a PNG. The library reports errors by a jump out of its calls, so member functions that call it have no objects with
/// destructors, and return true for success.
class PngReader {
public:
    explicit PngReader(std::string_view bytes) : bytes_(bytes) {}
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    bool begin() {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
        if (png_ == nullptr) return false;
        info_ = png_create_info_struct(png_);
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;
        png_set_read_fn(png_, this, on_read);
        png_set_user_limits(png_, most_pixels, most_pixels);
        png_set_chunk_malloc_max(png_, 10'000'000);
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
        png_read_info(png_, info_);
        return true;
    }
    /// Converts samples to one byte, or two for 16 bits, the lower first.
    bool transform() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_set_packing(png_);
        if (png_get_bit_depth(png_, info_) == 16) png_set_swap(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    bool read(unsigned char** rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }

    [[nodiscard]] std::size_t width() const { return png_get_image_width(png_, info_); }
    [[nodiscard]] std::size_t height() const { return png_get_image_height(png_, info_); }
    [[nodiscard]] int bits() const { return png_get_bit_depth(png_, info_); }
    [[nodiscard]] int colour_type() const { return png_get_color_type(png_, info_); }
    [[nodiscard]] std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
    /// The colours of a palette; empty without one.
    [[nodiscard]] std::vector<int> palette() const {
        png_colorp colours = nullptr;
        int n = 0;
        if (png_get_PLTE(png_, info_, &colours, &n) == 0) return {};
        std::vector<int> palette;
        for (int i = 0; i < n; ++i) palette.push_back(colours[i].red << 16 | colours[i].green << 8 | colours[i].blue);
        return palette;
    }
    [[nodiscard]] std::string message() const { return printable(message_.data()); }

private:
    static PngReader& reader_of(void* pointer) { return *static_cast<PngReader*>(pointer); }
    static void on_error(png_structp png, png_const_charp message) {
        auto& text = reader_of(png_get_error_ptr(png)).message_;
        std::strncpy(text.data(), message, text.size() - 1);
        png_longjmp(png, 1);
    }
    static void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}
    static void on_read(png_structp png, png_bytep data, std::size_t n) {
        PngReader& reader = reader_of(png_get_io_ptr(png));
        if (reader.bytes_.size() - reader.offset_ < n) png_error(png, "it ends too early");
        std::memcpy(data, reader.bytes_.data() + reader.offset_, n);
        reader.offset_ += n;
    }

    std::string_view bytes_;
    std::size_t offset_ = 0;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::array<char, 120> message_{};
};

void check_size(std::size_t width, std::size_t height, const std::string& name) {
    if (width == 0 || height == 0 || width > most_pixels / height) {
        throw InputError(
            fmt::format("{}: the picture has {} × {} pixels; at most {} are read", name, width, height, most_pixels));
    }
}

/// The samples of a pixel as one integer; it can be negative for colours of more than 31 bits.
int label_of(const unsigned char* pixel, int colour_type, int bits) {
    const auto sample = [&](int i) {
        if (bits < 16) return static_cast<unsigned>(pixel[i]);
        return static_cast<unsigned>(pixel[2 * i]) | static_cast<unsigned>(pixel[2 * i + 1]) << 8U;
    };
    unsigned label = sample(0);
    if (colour_type == PNG_COLOR_TYPE_GRAY_ALPHA) {
        if (bits < 16) return static_cast<int>(label | (255U - sample(1)) << 24U);
        return static_cast<int>(label | (65535U - sample(1)) << 16U);
    }
    if (colour_type == PNG_COLOR_TYPE_RGB || colour_type == PNG_COLOR_TYPE_RGB_ALPHA) {
        label = label << 16U | sample(1) << 8U | sample(2);
        if (colour_type == PNG_COLOR_TYPE_RGB_ALPHA) label |= (255U - sample(3)) << 24U;
    }
    return static_cast<int>(label);
}

std::string pixel_format(int colour_type, int bits) {
    std::string_view kind = "colours";
    if (colour_type == PNG_COLOR_TYPE_GRAY) kind = "grey";
    if (colour_type == PNG_COLOR_TYPE_GRAY_ALPHA) kind = "grey and alpha";
    if (colour_type == PNG_COLOR_TYPE_PALETTE) kind = "palette";
    if (colour_type == PNG_COLOR_TYPE_RGB_ALPHA) kind = "colours and alpha";
    return fmt::format("PNG, {}, {} bit{}", kind, bits, bits == 1 ? "" : "s");
}

/// The colours of labels that are greys or palette indices. \param bits of a sample in the file
std::vector<int> colours_of_labels(const PngReader& png, int bits) {
    if (png.colour_type() == PNG_COLOR_TYPE_PALETTE) return png.palette();
    std::vector<int> colours;
    if (png.colour_type() != PNG_COLOR_TYPE_GRAY || bits == 16) return colours;
    const int n = 1 << bits;
    for (int i = 0; i < n; ++i) colours.push_back(255 * i / (n - 1) * 0x010101);
    return colours;
}

LabelImage read_png(std::string_view bytes, const std::string& name) {
    PngReader png(bytes);
    const auto require = [&](bool good) {
        if (!good) throw InputError(fmt::format("{}: the PNG is damaged: {}; a whole picture is needed", name, png.message()));
    };
    require(png.begin());
    check_size(png.width(), png.height(), name);
    const int type = png.colour_type();
    const int bits = png.bits();
    if (bits == 16 && (type == PNG_COLOR_TYPE_RGB || type == PNG_COLOR_TYPE_RGB_ALPHA)) {
        throw InputError(name +
                         ": the PNG has colours of 16 bits; colours of 8 bits, greys of 8 or 16 bits or a palette are needed");
    }
    require(png.transform());
    LabelImage image{static_cast<int>(png.width()), static_cast<int>(png.height()), {}, pixel_format(type, bits), {}};
    image.palette = colours_of_labels(png, bits);
    image.are_colours = type == PNG_COLOR_TYPE_RGB || type == PNG_COLOR_TYPE_RGB_ALPHA;
    const std::size_t row_bytes = png.row_bytes();
    const std::size_t pixel_bytes = row_bytes / png.width();
    std::vector<unsigned char> bytes_of_rows(row_bytes * png.height());
    std::vector<unsigned char*> rows;
    for (std::size_t j = 0; j < png.height(); ++j) rows.push_back(bytes_of_rows.data() + j * row_bytes);
    require(png.read(rows.data()));
    for (const unsigned char* row : rows) {
        for (std::size_t i = 0; i < png.width(); ++i) image.labels.push_back(label_of(row + i * pixel_bytes, type, bits));
    }
    return image;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

int parse_label(std::string_view text, std::size_t row, const std::string& name) {
    int value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || value < 0) {
        throw InputError(fmt::format("{}: row {} has \"{}\"; whole numbers from 0 to {}, separated by tabs or blanks, are needed",
                                     name, row, printable(shortened(text, 40)), std::numeric_limits<int>::max()));
    }
    return value;
}

LabelImage read_text(std::string_view text, const std::string& name) {
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    while (!text.empty() && (is_blank(text.back()) || text.back() == '\n')) text.remove_suffix(1);
    if (text.empty()) throw InputError(name + ": there is no number in it; the rows of a picture are needed");
    LabelImage image;
    image.format = "text";
    std::size_t width = 0, row = 0;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::size_t before = image.labels.size();
        ++row;
        for (std::size_t i = begin; i < end;) {
            if (is_blank(text[i])) {
                ++i;
                continue;
            }
            std::size_t stop = i;
            while (stop < end && !is_blank(text[stop])) ++stop;
            if (image.labels.size() == most_pixels) throw InputError(fmt::format("{}: more than {} pixels", name, most_pixels));
            image.labels.push_back(parse_label(text.substr(i, stop - i), row, name));
            i = stop;
        }
        const std::size_t n = image.labels.size() - before;
        if (row == 1) width = n;
        if (n != width || n == 0) {
            throw InputError(row == 1 ? fmt::format("{}: row 1 has no number; each row of the picture needs as many", name)
                                      : fmt::format("{}: row {} has {} number{}, the rows above {}; all need as many", name, row,
                                                    n, n == 1 ? "" : "s", width));
        }
        begin = end + 1;
    }
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(row);
    return image;
}

}  // namespace

std::optional<int> LabelImage::colour_of(int label) const {
    constexpr int n_colours = 1 << 24;
    if (are_colours) return label >= 0 && label < n_colours ? std::optional(label) : std::nullopt;
    if (label < 0 || label >= static_cast<int>(palette.size())) return std::nullopt;
    return palette[static_cast<std::size_t>(label)];
}

bool is_binary(std::string_view bytes) {
    const auto first = bytes.empty() ? 0U : static_cast<unsigned char>(bytes.front());
    const bool begins_amid_character = (first & 0xc0U) == 0x80U || first >= 0xf8U;  // UTF-8
    return !bytes.starts_with(png_signature) && (begins_amid_character || bytes.substr(0, 40).find('\0') < 40);
}

LabelImage read_label_image(std::string_view bytes, const std::string& name) {
    if (is_binary(bytes)) throw InputError(name + ": is no PNG and no text; save the picture as PNG");
    return bytes.starts_with(png_signature) ? read_png(bytes, name) : read_text(bytes, name);
}

bool looks_like_labels(std::string_view bytes) {
    if (bytes.starts_with(png_signature)) return true;
    if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    return std::any_of(bytes.begin(), bytes.end(), is_digit) && std::all_of(bytes.begin(), bytes.end(), [&](char c) {
               return is_digit(c) || is_blank(c) || c == '\n' || c == '-' || c == '+';
           });
}

}  // namespace graincrack::mesher
