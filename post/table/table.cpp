#include "post/table/table.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack {

namespace {

constexpr int terminal_digits = 5;

std::string tsv_text(const Cell& cell) {
    std::string clean = cell.text();
    std::replace_if(
        clean.begin(), clean.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
    return printable(clean);
}

/// A bar would end the cell.
std::string markdown_text(const Cell& cell) {
    std::string text = tsv_text(cell);
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
    return text;
}

void write_markdown_row(std::ostream& out, const std::vector<Cell>& cells) {
    out << '|';
    for (const Cell& each : cells) out << ' ' << markdown_text(each) << " |";
    out << '\n';
}

std::string json_string(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_text(const Cell& cell) {
    if (cell.empty()) return "null";
    return cell.is_number() ? cell.text() : json_string(cell.text());
}

/// Fewer digits of a real number, but not of one that has none behind the point.
std::string terminal_text(const Cell& cell) {
    std::string text = cell.text();
    return cell.is_number() && text.find_first_of(".e") != std::string::npos ? cell.text(terminal_digits) : text;
}

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

/// The lines side by side as columns, the first of them as the first column. \pre lines are equally long
std::vector<AlignedLine> transposed(const std::vector<AlignedLine>& lines) {
    std::vector<AlignedLine> out(lines.front().size());
    for (const AlignedLine& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) out[i].push_back(line[i]);
    }
    return out;
}

/// True if the lines, which are few, would be wider than a terminal and stand better side by side. \pre lines are equally long
bool is_wide(const std::vector<AlignedLine>& lines) {
    if (lines.empty() || lines.size() > most_side_by_side + 1) return false;
    std::size_t sum = 0;
    for (const std::size_t width : widths_of(lines)) sum += width + 2;
    return sum > terminal_width;
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

Cell::Cell(double value) {
    if (std::isfinite(value)) {
        value_ = value == 0 ? 0.0 : value;  // no -0
    } else {
        value_ = std::monostate{};
    }
}

bool Cell::empty() const {
    const auto* const text = std::get_if<std::string>(&value_);
    return text != nullptr ? text->empty() : std::holds_alternative<std::monostate>(value_);
}

std::string Cell::text(int digits) const {
    if (const auto* const real = std::get_if<double>(&value_)) return format_number(*real, digits);
    if (const auto* const whole = std::get_if<std::int64_t>(&value_)) return std::to_string(*whole);
    const auto* const text = std::get_if<std::string>(&value_);
    return text != nullptr ? *text : "";
}

Cell Cell::times(double factor) const {
    const auto* const real = std::get_if<double>(&value_);
    return real != nullptr && factor != 1 ? Cell(*real * factor) : *this;
}

Cell count_cell(double count) {
    if (count == std::floor(count) && std::abs(count) < 9e15) return static_cast<std::int64_t>(count);
    return count;
}

TableWriter::TableWriter(std::ostream& out, std::vector<std::string> columns, TableFormat format)
    : out_(out), columns_(std::move(columns)), format_(format) {
    if (format_ == TableFormat::markdown) {
        write_markdown_row(out_, {columns_.begin(), columns_.end()});
        out_ << '|';
        for (std::size_t i = 0; i < columns_.size(); ++i) out_ << "---|";
        out_ << '\n';
    }
    if (format_ == TableFormat::aligned) aligned_.push_back(columns_);
    if (format_ != TableFormat::tsv) return;
    for (std::size_t i = 0; i < columns_.size(); ++i) out_ << (i == 0 ? "" : "\t") << printable(columns_[i]);
    out_ << '\n';
}

TableWriter::~TableWriter() { write_aligned(out_, is_wide(aligned_) ? transposed(aligned_) : aligned_); }

void TableWriter::row(const std::vector<Cell>& cells) {
    assert(cells.size() == columns_.size());
    if (format_ == TableFormat::aligned) {
        std::vector<std::string>& row = aligned_.emplace_back();
        for (const Cell& each : cells) row.push_back(terminal_text(each));
        return;
    }
    if (format_ == TableFormat::markdown) return write_markdown_row(out_, cells);
    const bool json = format_ == TableFormat::jsonl;
    if (json) out_ << '{';
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (json) {
            out_ << (i == 0 ? "" : ", ") << json_string(columns_[i]) << ": " << json_text(cells[i]);
        } else {
            out_ << (i == 0 ? "" : "\t") << tsv_text(cells[i]);
        }
    }
    out_ << (json ? "}\n" : "\n");
}

std::optional<double> parse_number(const std::string& text) {
    const char* from = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
    const char* const to = text.data() + text.size();
    double value = 0;
    const auto [end, error] = std::from_chars(from, to, value);
    if (error != std::errc{} || end != to) return std::nullopt;
    return value;
}

}  // namespace graincrack
