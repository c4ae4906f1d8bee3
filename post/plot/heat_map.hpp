// A table of numbers as coloured cells.
#pragma once

#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"

namespace graincrack {

/// A cell: positive values are red, negative blue, the stronger the larger; faint ones have no colour.
struct HeatCell {
    double value = 0;
    std::string text;
    bool faint = false;
};

/// \param cells a row for each name of `rows`, as long as `columns` \param largest value of the strongest colour
Drawing draw_heat_map(const std::string& title, const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                      const std::vector<std::vector<HeatCell>>& cells, double largest, const PictureStyle& style = {});

}  // namespace graincrack
