#include "post/plot/heat_map.hpp"

#include <algorithm>
#include <cmath>

#include "post/chart/font.hpp"
#include "post/chart/page.hpp"

namespace graincrack {

namespace {

constexpr double row_height = 44;
constexpr double letter_size = 22;
constexpr double gap = 14;

Colour blended(Colour strongest, double share) {
    const auto part = [&](std::uint8_t c) { return static_cast<std::uint8_t>(std::lround(255 + share * (c - 255))); };
    return {part(strongest.red), part(strongest.green), part(strongest.blue)};
}

}  // namespace

Drawing draw_heat_map(const std::string& title, const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                      const std::vector<std::vector<HeatCell>>& cells, double largest, const PictureStyle& style) {
    double names = 0;
    for (const std::string& row : rows) names = std::max(names, text_width(row, letter_size));
    const double left = names + 2 * gap;
    const double width = (style.page_width - left - gap) / static_cast<double>(std::max<std::size_t>(columns.size(), 1));
    const double top = 3 * row_height;
    Drawing drawing(static_cast<int>(style.page_width),
                    static_cast<int>(top + row_height * static_cast<double>(rows.size()) + gap));
    drawing.text({{gap, row_height}, title, letter_size, palette::ink, Anchor::start, true});
    for (std::size_t k = 0; k < columns.size(); ++k) {
        // Names that are wider than their columns stand on two lines by turns, and stay on the page.
        const double y = top - gap - (k % 2 == 0 ? 0 : 0.7 * row_height);
        const double half = 0.5 * text_width(columns[k], letter_size);
        const double x = std::min(left + (static_cast<double>(k) + 0.5) * width, style.page_width - gap - half);
        drawing.text({{x, y}, columns[k], letter_size, palette::ink, Anchor::middle});
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double y = top + row_height * static_cast<double>(i);
        drawing.text({{left - gap, y + 0.7 * row_height}, rows[i], letter_size, palette::ink, Anchor::end});
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const HeatCell& cell = cells[i][k];
            const double share = cell.faint ? 0 : std::min(1.0, std::abs(cell.value) / largest);
            const double x = left + width * static_cast<double>(k);
            drawing.rectangle({x + 1, y + 1}, {x + width - 1, y + row_height - 1},
                              blended(cell.value > 0 ? palette::tensile : palette::pre_existing, 0.75 * share));
            drawing.text({{x + 0.5 * width, y + 0.7 * row_height},
                          with_minus(cell.text),
                          letter_size,
                          cell.faint ? palette::rim : palette::ink,
                          Anchor::middle});
        }
    }
    return drawing;
}

}  // namespace graincrack
