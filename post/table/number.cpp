#include "post/table/number.hpp"

#include <charconv>

namespace graincrack {

std::optional<double> parse_number(const std::string& text) {
    const char* from = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
    const char* const to = text.data() + text.size();
    double value = 0;
    const auto [end, error] = std::from_chars(from, to, value);
    if (error != std::errc{} || end != to) return std::nullopt;
    return value;
}

}  // namespace graincrack
