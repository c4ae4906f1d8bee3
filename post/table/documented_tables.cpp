#include "post/table/documented_tables.hpp"

#include <regex>
#include <string>

#include "post/table/column.hpp"
#include "share/base/text.hpp"
#include "share/file/history.hpp"

namespace graincrack {

extern const char* const columns_text;  // made of share/doc/columns.tsv

namespace {

/// The unit that ends the name of a column; "" of a pure number or a word, also where it is that of a number in the name, as of
/// specimens_for_3_percent.
std::string unit_of(const std::string& name) {
    std::string longest;
    using namespace graincrack::unit;
    for (const ColumnUnit& each : {second, metre, radian, joule, newton_metre, joule_per_area, kilonewton_per_metre, millimetre,
                                   square_millimetre, megapascal, gigapascal, degree, percent, toughness}) {
        if (each.name.size() > longest.size() && name.ends_with("_" + std::string(each.name))) longest = each.name;
    }
    const std::string before = name.substr(0, name.size() - longest.size());
    const bool is_of_number = before.size() > 1 && before[before.size() - 2] >= '0' && before[before.size() - 2] <= '9';
    return is_of_number && (longest == degree.name || longest == percent.name) ? "" : longest;
}

/// Adds "a_m" and "b_m" for the text "{a,b}_m".
void add_names(const std::string& text, const std::string& meaning, std::vector<NamedValue>& columns) {
    const std::size_t open = text.find('{');
    if (open == std::string::npos && text != "…") columns.push_back({text, unit_of(text), meaning});
    if (open == std::string::npos) return;
    const std::size_t close = text.find('}', open);
    for (const std::string_view part : split(std::string_view(text).substr(open + 1, close - open - 1), ',')) {
        add_names(text.substr(0, open) + std::string(part) + text.substr(close + 1), meaning, columns);
    }
}

}  // namespace

std::vector<TableRow> tables_of_rows(std::string_view rows) {
    std::vector<TableRow> tables;
    for (const std::string_view line : split(rows.substr(rows.find('\n') + 1), '\n')) {
        if (line.empty()) continue;
        const std::vector<std::string_view> cells = split(line, '\t');
        const std::string command(cells.at(0)), file(cells.at(1)), meaning(cells.at(3));
        const bool goes_on = !tables.empty() && tables.back().command == command && tables.back().file == file;
        if (!goes_on) tables.push_back({command, file, {}});
        const std::string names = std::regex_replace(std::string(cells.at(2)), std::regex(", "), "\n");
        for (const std::string_view name : split(names, '\n')) add_names(std::string(name), meaning, tables.back().columns);
    }
    return tables;
}

std::vector<TableRow> documented_tables() {
    std::vector<TableRow> tables = tables_of_rows(columns_text);
    TableRow& history = *tables.insert(tables.begin(), TableRow{"history", "", {}});
    for (const HistoryDataset& column : history_datasets) {
        const std::string unit(column.dimension == Dimension::one ? "" : si_unit(column.dimension));
        history.columns.push_back({script_name(std::string(column.name), {unit}), unit, std::string(column.description)});
    }
    return tables;
}

}  // namespace graincrack
