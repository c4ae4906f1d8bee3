// Tables on stdout: TSV with one header line, or the same as JSON lines, Markdown or aligned columns; numbers alike in every
// locale.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace graincrack {

enum class TableFormat { tsv, jsonl, markdown, aligned };
/// The columns of a table for scripts: those that most people want, or all.
enum class ColumnChoice { usual, all };

/// One entry: empty, a number or a text. NaN and infinity are empty: the value does not apply.
class Cell {
public:
    Cell() = default;
    Cell(double value);
    template <std::integral Integer>
    Cell(Integer value) : value_(static_cast<std::int64_t>(value)) {}
    Cell(std::string text) : value_(std::move(text)) {}
    Cell(std::string_view text) : value_(std::string(text)) {}
    Cell(const char* text) : value_(std::string(text)) {}
    template <class Value>
    Cell(const std::optional<Value>& value) : Cell(value ? Cell(*value) : Cell()) {}
    [[nodiscard]] bool empty() const;
    [[nodiscard]] bool is_number() const { return !std::holds_alternative<std::string>(value_); }
    /// A real number with some significant digits, a whole one with all. \return "" if empty
    [[nodiscard]] std::string text(int digits = 7) const;
    /// A real number times a factor; anything else as it is.
    [[nodiscard]] Cell times(double factor) const;

private:
    std::variant<std::monostate, double, std::int64_t, std::string> value_;
};
/// A count as an integer cell, or as a number if it is a half.
Cell count_cell(double count);

/// Writes rows as they come, reals with 7 significant digits, what is empty as nothing (TSV) or null (JSON); aligned columns,
/// with 5 digits, at its end, since their widths are those of all rows.
class TableWriter {
public:
    TableWriter(std::ostream& out, std::vector<std::string> columns, TableFormat format);
    TableWriter(const TableWriter&) = delete;
    TableWriter& operator=(const TableWriter&) = delete;
    ~TableWriter();
    /// \pre one cell a column
    void row(const std::vector<Cell>& cells);

private:
    std::ostream& out_;
    std::vector<std::string> columns_;
    TableFormat format_;
    std::vector<std::vector<std::string>> aligned_;  ///< names and rows so far
};

/// A line of texts, one a column; a line with a single text where there are more columns is a title above the lines that follow.
using AlignedLine = std::vector<std::string>;

/// Columns as wide as their widest text, the first aligned left, the others right; an empty text shows as a dash.
void write_aligned(std::ostream& out, const std::vector<AlignedLine>& lines);

/// A number, empty if the text is none.
std::optional<double> parse_number(const std::string& text);

}  // namespace graincrack
