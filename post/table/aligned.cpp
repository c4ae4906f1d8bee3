#include "post/table/aligned.hpp"

#include <algorithm>

#include "share/base/printable.hpp"

namespace graincrack {

namespace {

constexpr std::size_t terminal_width = 120;
constexpr std::size_t most_side_by_side = 6;

/// Characters of a text in UTF-8.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

std::string shown(const std::string& text) { return text.empty() ? "-" : printable(text); }

bool is_title(const AlignedLine& line, std::size_t columns) { return line.size() == 1 && columns > 1; }

std::vector<std::size_t> widths_of(const std::vector<AlignedLine>& lines) {
    std::vector<std::size_t> widths(lines.front().size(), 0);
    for (const AlignedLine& line : lines) {
        if (is_title(line, widths.size())) continue;
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width_of(shown(line[i])));
    }
    return widths;
}

}  // namespace

void write_aligned(std::ostream& out, const std::vector<AlignedLine>& lines) {
    if (lines.empty() || lines.front().empty()) return;
    const std::vector<std::size_t> widths = widths_of(lines);
    for (const AlignedLine& line : lines) {
        if (is_title(line, widths.size())) {
            out << '\n' << printable(line.front()) << '\n';
            continue;
        }
        std::string text;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string entry = shown(line[i]);
            const std::string blanks(widths[i] - width_of(entry), ' ');
            text += i == 0 ? entry + blanks : "  " + blanks + entry;
        }
        text.erase(text.find_last_not_of(' ') + 1);
        out << text << '\n';
    }
}

std::vector<AlignedLine> transposed(const std::vector<AlignedLine>& lines) {
    std::vector<AlignedLine> out(lines.front().size());
    for (const AlignedLine& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) out[i].push_back(line[i]);
    }
    return out;
}

bool is_wide(const std::vector<AlignedLine>& lines) {
    if (lines.empty() || lines.size() > most_side_by_side + 1) return false;
    std::size_t sum = 0;
    for (const std::size_t width : widths_of(lines)) sum += width + 2;
    return sum > terminal_width;
}

}  // namespace graincrack
