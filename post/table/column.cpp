#include "post/table/column.hpp"

#include <algorithm>
#include <cassert>

#include "post/table/table.hpp"

namespace graincrack {

namespace {

constexpr int digits_of_an_interval = 4;

/// A unit as people write it.
std::string symbol_of(const ColumnUnit& unit) {
    return unit.name == unit::percent.name     ? "%"
           : unit.name == unit::degree.name    ? "°"
           : unit.name == unit::toughness.name ? "MPa√m"
                                               : std::string(unit.name);
}

}  // namespace

Cell interval_cell(const std::optional<double>& low, const std::optional<double>& high, const ColumnUnit& unit) {
    if (!low || !high) return {};
    return Cell(*low * unit.factor).text(digits_of_an_interval) + " to " + Cell(*high * unit.factor).text(digits_of_an_interval);
}

void TerminalTable::head(const std::string& name, const ColumnUnit& unit) {
    names_.push_back(name);
    units_.push_back(symbol_of(unit));
}

void TerminalTable::row(const std::vector<Cell>& cells) {
    assert(cells.size() == names_.size());
    std::vector<std::string>& line = lines_.emplace_back();
    for (const Cell& each : cells) line.push_back(each.text(digits_of_an_interval));
}

void TerminalTable::write(std::ostream& out) const {
    std::vector<std::vector<std::string>> lines{names_};
    if (std::any_of(units_.begin(), units_.end(), [](const std::string& unit) { return !unit.empty(); })) {
        lines.push_back(units_);
        for (std::string& unit : lines.back()) {
            if (unit.empty()) unit = " ";  // no dash
        }
    }
    lines.insert(lines.end(), lines_.begin(), lines_.end());
    write_aligned(out, lines);
}

}  // namespace graincrack
