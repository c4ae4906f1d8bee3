// A table as a list of its columns: name, unit and value stand in one place, and give every form of the table.
#pragma once

#include <algorithm>
#include <functional>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "post/table/table.hpp"
#include "share/base/quantities.hpp"

namespace graincrack {

/// ColumnUnit in which a column shows its SI values.
struct ColumnUnit {
    std::string_view name = {};
    double factor = 1;  ///< from SI
};
namespace unit {
inline constexpr ColumnUnit none{}, second{"s"}, metre{"m"}, radian{"rad"}, joule{"J"}, newton_metre{"N_m"},
    joule_per_area{"J/m2"}, kilonewton_per_metre{"kN/m", 1e-3}, millimetre{"mm", 1e3}, square_millimetre{"mm2", 1e6},
    megapascal{"MPa", 1e-6}, gigapascal{"GPa", 1e-9}, degree{"deg", 180 / std::numbers::pi}, percent{"percent", 1e2},
    toughness{"MPa.m^0.5", 1e-6};
}
/// That of values of a dimension of which a table may have any: mm, MPa, deg, MPa.m^0.5, and SI for others; none of pure numbers.
ColumnUnit unit_in_tables(Dimension dimension);
/// Factors by which a stress or an angle is multiplied to be shown.
inline constexpr double in_megapascals = unit::megapascal.factor, in_degrees = unit::degree.factor;

/// A column of a table of which each row shows one `Row`.
template <class Row>
struct Column {
    std::string name;
    ColumnUnit unit;
    std::function<Cell(const Row&)> value;  ///< SI; texts and whole numbers are shown as they are
    bool is_further = false;                ///< whether a table for scripts has it only among all columns
};
template <class Row>
using Columns = std::vector<Column<Row>>;
inline constexpr bool further = true;

/// A unit as people write it: "%", "°".
std::string symbol_of(const ColumnUnit& unit);

/// "LOW to HIGH" in a unit, for terminal tables; empty without them.
Cell interval_cell(const std::optional<double>& low, const std::optional<double>& high, const ColumnUnit& unit);

/// The name of a column for scripts: its unit ends it, as in "mean_edge_mm".
inline std::string script_name(const std::string& name, const ColumnUnit& unit) {
    return unit.name.empty() ? name : name + "_" + std::string(unit.name);
}
template <class Row>
std::vector<std::string> script_names(const Columns<Row>& columns) {
    std::vector<std::string> names;
    for (const Column<Row>& column : columns) names.push_back(script_name(column.name, column.unit));
    return names;
}
template <class Row>
std::vector<Cell> cells_of(const Columns<Row>& columns, const Row& row) {
    std::vector<Cell> cells;
    for (const Column<Row>& column : columns) cells.push_back(column.value(row).times(column.unit.factor));
    return cells;
}

/// The table for scripts, a row for each of `rows`.
template <class Row>
void write_table(std::ostream& out, Columns<Row> columns, const std::vector<Row>& rows, TableFormat format,
                 ColumnChoice choice = ColumnChoice::all) {
    if (choice == ColumnChoice::usual) std::erase_if(columns, [](const Column<Row>& column) { return column.is_further; });
    TableWriter table(out, script_names(columns), format);
    for (const Row& row : rows) table.row(cells_of(columns, row));
}

/// A table for reading: few columns, their units in a line below their names, rows in groups under a title, four digits; a
/// column without a value in any row is left out.
class TerminalTable {
public:
    template <class Row>
    explicit TerminalTable(const Columns<Row>& columns) {
        for (const Column<Row>& column : columns) {
            names_.push_back(column.name);
            units_.push_back(symbol_of(column.unit));
        }
    }
    explicit TerminalTable(const std::vector<std::string>& names) : names_(names), units_(names.size()) {}
    /// A title above the rows that follow.
    void group(const std::string& title) { lines_.push_back({title}); }
    /// \pre one cell a column
    void row(const std::vector<Cell>& cells);
    void write(std::ostream& out) const;

private:
    std::vector<std::string> names_, units_;
    std::vector<std::vector<std::string>> lines_;
};

/// The table for scripts or, aligned, the one for reading.
template <class Row>
void write_table(std::ostream& out, const Columns<Row>& columns, const Columns<Row>& terminal_columns,
                 const std::vector<Row>& rows, TableFormat format) {
    if (format != TableFormat::aligned) return write_table(out, columns, rows, format);
    TerminalTable table(terminal_columns);
    for (const Row& row : rows) table.row(cells_of(terminal_columns, row));
    table.write(out);
}

}  // namespace graincrack
