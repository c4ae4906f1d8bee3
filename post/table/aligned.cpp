#include "post/table/aligned.hpp"

#include <algorithm>

#include "share/base/printable.hpp"

namespace graincrack {

namespace {

constexpr std::size_t terminal_width = 120;
constexpr std::size_t most_side_by_side = 6;

std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    return widths;
}

std::size_t line_width(const std::vector<std::size_t>& widths) {
    std::size_t sum = 0;
    for (const std::size_t width : widths) sum += width + 2;
    return sum;
}

std::vector<std::vector<std::string>> transposed(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::vector<std::string>> out(rows.front().size());
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) out[i].push_back(row[i]);
    }
    return out;
}

}  // namespace

std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

std::string padded(const std::string& text, std::size_t width, bool left) {
    const std::string room(width - std::min(width, width_of(text)), ' ');
    return left ? text + room : room + text;
}

void write_aligned(std::ostream& out, std::vector<std::vector<std::string>> rows) {
    if (rows.empty() || rows.front().empty()) return;
    for (auto& row : rows) {
        for (std::string& text : row) text = text.empty() ? "-" : printable(text);
    }
    std::vector<std::size_t> widths = widths_of(rows);
    if (rows.size() <= most_side_by_side + 1 && line_width(widths) > terminal_width) {
        rows = transposed(rows);
        widths = widths_of(rows);
    }
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) line += (i == 0 ? "" : "  ") + padded(row[i], widths[i], i == 0);
        line.erase(line.find_last_not_of(' ') + 1);
        out << line << '\n';
    }
}

}  // namespace graincrack
