#include "post/chart/pixel_fill.hpp"

#include <algorithm>
#include <cmath>

namespace graincrack {

namespace {

constexpr std::uint32_t filled = 1U << 24U;

std::uint32_t cell_of(Colour c) { return filled | (c.red * 65536U) | (c.green * 256U) | c.blue; }

Colour colour_of(std::uint32_t cell) {
    const auto part = [cell](unsigned shift) { return static_cast<std::uint8_t>((cell >> shift) & 255U); };
    return {part(16), part(8), part(0)};
}

/// Twice the area of a triangle, with the sense of turning.
double cross(Pixel a, Pixel b, Pixel c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

}  // namespace

PixelFill::PixelFill(Pixel top_left, Pixel bottom_right)
    : left_(static_cast<int>(std::floor(top_left.x))),
      top_(static_cast<int>(std::floor(top_left.y))),
      columns_(std::max(0, static_cast<int>(std::ceil(bottom_right.x)) - left_)),
      rows_(std::max(0, static_cast<int>(std::ceil(bottom_right.y)) - top_)),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

void PixelFill::triangle(Pixel a, Pixel b, Pixel c, Colour colour) {
    const double sense = cross(a, b, c) < 0 ? -1 : 1;
    const auto [x_low, x_high] = std::minmax({a.x, b.x, c.x});
    const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
    const auto first = [](double low, int from) { return std::max(0.0, std::ceil(low - from - 0.5)); };
    const auto last = [](double high, int from, int n) { return std::min(n - 1.0, std::floor(high - from - 0.5)); };
    for (double row = first(y_low, top_); row <= last(y_high, top_, rows_); ++row) {
        for (double column = first(x_low, left_); column <= last(x_high, left_, columns_); ++column) {
            const Pixel centre{left_ + column + 0.5, top_ + row + 0.5};
            const bool inside =
                sense * cross(a, b, centre) >= 0 && sense * cross(b, c, centre) >= 0 && sense * cross(c, a, centre) >= 0;
            const auto index =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
            if (inside) cells_[index] = cell_of(colour);
        }
    }
}

void PixelFill::draw(Drawing& drawing) const {
    constexpr double overlap = 0.5;  // downwards, so that rows do not come apart where a viewer scales the picture
    const auto columns = static_cast<std::size_t>(columns_);
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
        for (std::size_t from = 0; from < columns;) {
            const std::uint32_t cell = cells_[row * columns + from];
            std::size_t to = from + 1;
            while (to < columns && cells_[row * columns + to] == cell) ++to;
            if (cell != 0) {
                const double y = top_ + static_cast<double>(row);
                drawing.rectangle({left_ + static_cast<double>(from), y}, {left_ + static_cast<double>(to), y + 1 + overlap},
                                  colour_of(cell));
            }
            from = to;
        }
    }
}

}  // namespace graincrack
