#include "post/summary/summarize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "post/summary/expression.hpp"
#include "post/summary/text_template.hpp"
#include "post/table/condition.hpp"
#include "share/base/error.hpp"

namespace graincrack::summary {

namespace {

struct Group {
    std::vector<std::string> key;
    std::vector<std::size_t> rows;
};

std::vector<Condition> conditions_of(const SummaryOptions& options, const JoinedRows& rows) {
    std::vector<Condition> conditions;
    for (const std::string& text : options.where) {
        const auto condition = parse_condition(text);
        if (!condition) throw UsageError(fmt::format("--where {}: {}", text, condition_form));
        static_cast<void>(rows.column(condition->column));  // there must be one
        conditions.push_back(*condition);
    }
    return conditions;
}

bool all_meet(const std::vector<Condition>& conditions, const JoinedRows& rows, std::size_t row) {
    return std::all_of(conditions.begin(), conditions.end(),
                       [&](const Condition& condition) { return meets(condition, rows.column(condition.column)[row]); });
}

bool before(const std::string& a, const std::string& b) {
    const auto x = parse_number(a);
    const auto y = parse_number(b);
    if (x && y) return *x < *y;
    if (x || y) return x.has_value();
    return a < b;
}

/// NAME and EXPRESSION of an option. \throws UsageError
std::pair<std::string, std::string> assignment(const std::string& text, const char* option) {
    const std::size_t at = text.find('=');
    if (at != 0 && at != std::string::npos) return {text.substr(0, at), text.substr(at + 1)};
    throw UsageError(fmt::format("{} {}: NAME=EXPRESSION is needed, as runs=n(file)", option, text));
}

/// The entries of a column, or of an expression of each row.
std::vector<std::string> entries_of(const std::string& by, const JoinedRows& rows) {
    if (by.find('=') == std::string::npos) return rows.column(by);
    const RowExpression expression = parse_row_expression(assignment(by, "--by").second, rows);
    std::vector<std::string> entries;
    for (std::size_t row = 0; row < rows.size(); ++row) entries.push_back(cell(expression(row)).text());
    return entries;
}

std::vector<Group> groups_of(const JoinedRows& rows, const SummaryOptions& options) {
    const std::vector<Condition> conditions = conditions_of(options, rows);
    std::vector<std::vector<std::string>> by;
    for (const std::string& text : options.by) by.push_back(entries_of(text, rows));
    std::vector<Group> groups;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (!all_meet(conditions, rows, row)) continue;
        std::vector<std::string> key;
        for (const std::vector<std::string>& entries : by) key.push_back(entries[row]);
        auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.key == key; });
        if (group == groups.end()) group = groups.insert(groups.end(), Group{key, {}});
        group->rows.push_back(row);
    }
    if (options.sort) {
        std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
            return std::lexicographical_compare(a.key.begin(), a.key.end(), b.key.begin(), b.key.end(), before);
        });
    }
    return groups;
}

/// The tables that are named; with --label as LABEL=FILE.
JoinedRows rows_of(const std::vector<std::string>& files, const SummaryOptions& options) {
    Joining joining{options.join, options.label, {}};
    std::vector<TableFile> tables;
    for (const std::string& file : files) {
        const std::size_t at = options.label.empty() ? std::string::npos : file.find('=');
        if (!options.label.empty() && (at == 0 || at == std::string::npos)) {
            throw UsageError(fmt::format("{}: with --label a table is LABEL=FILE", file));
        }
        tables.emplace_back(at == std::string::npos ? file : file.substr(at + 1));
        joining.labels.push_back(file.substr(0, at));
    }
    JoinedRows rows(tables, joining);
    for (const std::string& file : options.look_up) rows.look_up(TableFile(file));
    return rows;
}

/// A column of the summary: an entry from the rows of a group.
using Column = std::function<Cell(const std::vector<std::size_t>&)>;

Column column_of(const std::string& text, const JoinedRows& rows) {
    if (text.find('{') != std::string::npos) {
        return [fill = parse_template(text, rows)](const std::vector<std::size_t>& group) { return Cell(fill(group)); };
    }
    return [evaluate = parse_expression(text, rows)](const std::vector<std::size_t>& group) { return cell(evaluate(group)); };
}

Cell key_cell(const std::string& entry) {
    const auto number = parse_number(entry);
    return number ? Cell(*number) : Cell(entry);
}

}  // namespace

void write_summary(std::ostream& out, const std::vector<std::string>& files, const SummaryOptions& options) {
    const JoinedRows rows = rows_of(files, options);
    std::vector<std::string> names;
    for (const std::string& by : options.by) names.push_back(by.substr(0, by.find('=')));
    std::vector<Column> columns;
    for (const std::string& column : options.columns) {
        const auto [name, expression] = assignment(column, "--column");
        names.push_back(name);
        columns.push_back(column_of(expression, rows));
    }
    std::vector<std::vector<Cell>> cells;
    for (const Group& group : groups_of(rows, options)) {
        std::vector<Cell>& row = cells.emplace_back();
        for (const std::string& entry : group.key) row.push_back(key_cell(entry));
        for (const Column& column : columns) row.push_back(column(group.rows));
    }
    TableWriter table(out, names, options.format);
    for (const std::vector<Cell>& row : cells) table.row(row);
}

}  // namespace graincrack::summary
