// Text in columns on a terminal.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace graincrack {

/// A line of texts, one a column; a line with a single text where there are more columns is a title above the lines that follow.
using AlignedLine = std::vector<std::string>;

/// Columns as wide as their widest text, the first aligned left, the others right; an empty text shows as a dash.
void write_aligned(std::ostream& out, const std::vector<AlignedLine>& lines);

/// The lines side by side as columns, the first of them as the first column. \pre lines are equally long
std::vector<AlignedLine> transposed(const std::vector<AlignedLine>& lines);

/// Whether the lines, which are few, would be wider than a terminal and stand better side by side. \pre lines are equally long
bool is_wide(const std::vector<AlignedLine>& lines);

}  // namespace graincrack
