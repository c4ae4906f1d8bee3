// Text in columns on a terminal.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace graincrack {

/// Characters of a text in UTF-8.
std::size_t width_of(const std::string& text);
/// The text with blanks to this width, behind it (`left`) or before it.
std::string padded(const std::string& text, std::size_t width, bool left);
/// Columns as wide as their widest text, the first aligned left, the others right; an empty text shows as a dash. Rows that would
/// be wider than a terminal stand side by side as columns, under the first, if they are few. \pre rows are equally long
void write_aligned(std::ostream& out, std::vector<std::vector<std::string>> rows);

}  // namespace graincrack
