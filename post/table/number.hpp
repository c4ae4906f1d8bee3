// Numbers in the entries of tables.
#pragma once

#include <optional>
#include <string>

namespace graincrack {

/// A number, empty if the text is none.
std::optional<double> parse_number(const std::string& text);

}  // namespace graincrack
