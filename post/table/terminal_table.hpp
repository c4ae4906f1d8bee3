// Terminal tables: few columns with units, aligned, in groups under a line of their own.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/table/table.hpp"

namespace graincrack {

class TerminalTable {
public:
    struct Column {
        std::string heading;
        std::string unit;  ///< on a line below the headings
    };
    explicit TerminalTable(std::vector<Column> columns) : columns_(std::move(columns)) {}
    /// A line above the rows that follow.
    void group(const std::string& title) { lines_.push_back({title, {}}); }
    /// \pre one cell a column; an empty one shows as a dash
    void row(std::vector<std::string> cells) { lines_.push_back({"", std::move(cells)}); }
    /// The first column is aligned left, the others right.
    void write(std::ostream& out) const;

private:
    struct Line {
        std::string group;
        std::vector<std::string> cells;  ///< empty in the line of a group
    };
    std::vector<Column> columns_;
    std::vector<Line> lines_;
};

/// A row of a table for scripts, by the names of its columns.
class NamedRow {
public:
    /// Both must outlive this. \pre one cell a column
    NamedRow(const std::vector<std::string>& columns, const std::vector<Cell>& cells) : columns_(columns), cells_(cells) {}
    /// \pre the column is there
    [[nodiscard]] const std::string& text(const std::string& column) const;
    [[nodiscard]] std::optional<double> number(const std::string& column) const;
    /// With four significant digits; "" if empty. \param factor to the unit that is shown
    [[nodiscard]] std::string shown(const std::string& column, double factor = 1) const;

private:
    const std::vector<std::string>& columns_;
    const std::vector<Cell>& cells_;
};

}  // namespace graincrack
