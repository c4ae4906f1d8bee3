// Fills triangles smaller than a few pixels through the pixels of the page, so that the size of a picture is bounded by
// its page, not by the number of grains.
#pragma once

#include <cstdint>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack {

class PixelFill {
public:
    /// The pixels between two corners of the page.
    PixelFill(Pixel top_left, Pixel bottom_right);
    /// Colours the pixels whose centre lies in the triangle, in any sense of turning; what is off the page is left out.
    void triangle(Pixel a, Pixel b, Pixel c, Colour colour);
    /// Adds what was coloured to a drawing: a rectangle for each run of one colour in a row.
    void draw(Drawing& drawing) const;

private:
    int left_;
    int top_;
    int columns_;
    int rows_;
    std::vector<std::uint32_t> cells_;  ///< 0 empty, else 2²⁴ + red, green, blue
};

}  // namespace graincrack
