#include "post/table/column.hpp"

#include <algorithm>
#include <cassert>

#include "post/table/table.hpp"

namespace graincrack {

namespace {

constexpr int digits_of_an_interval = 4;

bool is_blank(const std::string& text) { return text.empty() || text == " "; }

}  // namespace

std::string symbol_of(const ColumnUnit& unit) {
    return unit.name == unit::percent.name     ? "%"
           : unit.name == unit::degree.name    ? "°"
           : unit.name == unit::toughness.name ? "MPa√m"
                                               : std::string(unit.name);
}

ColumnUnit unit_in_tables(Dimension dimension) {
    switch (dimension) {
        case Dimension::one: return unit::none;
        case Dimension::stress: return unit::megapascal;
        case Dimension::angle: return unit::degree;
        case Dimension::length: return unit::millimetre;
        case Dimension::toughness: return unit::toughness;
        default: return {si_unit(dimension)};
    }
}

Cell interval_cell(const std::optional<double>& low, const std::optional<double>& high, const ColumnUnit& unit) {
    if (!low || !high) return {};
    return Cell(*low * unit.factor).text(digits_of_an_interval) + " to " + Cell(*high * unit.factor).text(digits_of_an_interval);
}

void TerminalTable::row(const std::vector<Cell>& cells) {
    assert(cells.size() == names_.size());
    std::vector<std::string>& line = lines_.emplace_back();
    for (const Cell& each : cells) line.push_back(each.text(digits_of_an_interval));
}

void TerminalTable::write(std::ostream& out) const {
    std::vector<AlignedLine> lines{names_, units_};
    lines.insert(lines.end(), lines_.begin(), lines_.end());
    for (std::size_t i = names_.size(); !lines_.empty() && --i > 0;) {
        const auto has_value = [i](const AlignedLine& line) { return line.size() > i && !is_blank(line[i]); };
        if (std::ranges::any_of(lines_, has_value)) continue;
        for (AlignedLine& line : lines) {
            if (line.size() > i) line.erase(line.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    for (std::string& unit : lines[1]) {
        if (unit.empty()) unit = " ";  // no dash
    }
    if (std::ranges::all_of(lines[1], is_blank)) lines.erase(lines.begin() + 1);
    write_aligned(out, lines);
}

}  // namespace graincrack
