// Columns of any table against each other.
#pragma once

#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"

namespace graincrack {

struct TablePlotOptions {
    std::string x;
    std::vector<std::string> y;
    bool points = false;  ///< instead of lines
};

/// One curve for each column y of each table. \throws InputError for a missing column or one without numbers
Drawing draw_tables(const std::vector<std::string>& files, const TablePlotOptions& options, const PictureStyle& style = {});

Command table_plot();

}  // namespace graincrack
