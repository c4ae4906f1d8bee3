#include "post/table/terminal_table.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>

#include "post/table/aligned.hpp"
#include "share/base/printable.hpp"
#include "share/base/units.hpp"

namespace graincrack {

namespace {

std::string entry(const std::string& cell) { return cell.empty() ? "-" : printable(cell); }

}  // namespace

void TerminalTable::write(std::ostream& out) const {
    std::vector<std::size_t> widths;
    for (const Column& column : columns_) widths.push_back(std::max(width_of(column.heading), width_of(column.unit)));
    for (const Line& line : lines_) {
        for (std::size_t i = 0; i < line.cells.size(); ++i) widths[i] = std::max(widths[i], width_of(entry(line.cells[i])));
    }
    const auto write_line = [&](const auto& text_of) {
        std::string text;
        for (std::size_t i = 0; i < columns_.size(); ++i) text += (i == 0 ? "" : "  ") + padded(text_of(i), widths[i], i == 0);
        text.erase(text.find_last_not_of(' ') + 1);
        out << text << '\n';
    };
    write_line([&](std::size_t i) { return columns_[i].heading; });
    const bool has_units = std::any_of(columns_.begin(), columns_.end(), [](const Column& c) { return !c.unit.empty(); });
    if (has_units) write_line([&](std::size_t i) { return columns_[i].unit; });
    for (const Line& line : lines_) {
        if (line.cells.empty()) {
            out << '\n' << printable(line.group) << '\n';
        } else {
            assert(line.cells.size() == columns_.size());
            write_line([&](std::size_t i) { return entry(line.cells[i]); });
        }
    }
}

const std::string& NamedRow::text(const std::string& column) const {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    assert(found != columns_.end());
    return cells_[static_cast<std::size_t>(found - columns_.begin())].text();
}

std::optional<double> NamedRow::number(const std::string& column) const {
    const std::string& value = text(column);
    double number = 0;
    const auto [rest, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    return error == std::errc{} && rest == value.data() + value.size() ? std::optional(number) : std::nullopt;
}

std::string NamedRow::shown(const std::string& column, double factor) const {
    const std::optional<double> value = number(column);
    return value ? format_number(*value * factor, 4) : "";
}

}  // namespace graincrack
