// Tables on stdout: TSV with one header line, or the same as JSON lines, Markdown or aligned columns; numbers alike in every
// locale.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace graincrack {

enum class TableFormat { tsv, jsonl, markdown, aligned };

/// One entry: empty, a number or a text. Empty, NaN and infinity are written empty (TSV) or null (JSON): the value
/// does not apply. Reals carry 7 significant digits.
class Cell {
public:
    Cell() = default;
    Cell(double value);
    Cell(std::int64_t value);
    Cell(std::string text);
    [[nodiscard]] bool empty() const { return text_.empty(); }
    [[nodiscard]] bool is_number() const { return is_number_; }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
    bool is_number_ = false;
};
/// A cell from a value that may be missing.
Cell cell(const std::optional<double>& value);
/// A count as an integer cell, or as a number if it is a half.
Cell count_cell(double count);

/// Writes rows as they come; aligned columns at its end, since their widths are those of all rows.
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

/// A table of one row a file; all rows are made before the first is written.
void write_file_rows(std::ostream& out, const std::vector<std::string>& columns, const std::vector<std::string>& files,
                     const std::function<std::vector<Cell>(const std::string&)>& row_of, TableFormat format);

}  // namespace graincrack
