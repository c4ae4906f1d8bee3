// What a column of `summarize` is made of: "100 * deviation(A) / mean(A)", "n(A where peak_kind != drop)".
//
//     sum       = product { ("+" | "-") product }
//     product   = either { ("*" | "/") either }
//     either    = atom { "|" atom }              the first that is not empty
//     atom      = number | "-" atom | "abs" "(" sum ")" | "(" sum ")" | column
//     statistic = name "(" sum { "," sum } [ "where" condition { "and" condition } ] ")"
//
// Outside a statistic its atoms are statistics, inside they are columns. What has an empty part is empty, and so is x / 0.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "post/summary/joined_rows.hpp"
#include "post/summary/statistic.hpp"

namespace graincrack::summary {

/// A number from the rows of a group, by their places in the table.
using GroupExpression = std::function<Number(const std::vector<std::size_t>&)>;
/// A number from one row.
using RowExpression = std::function<Number(const std::size_t&)>;

/// \throws UsageError that quotes the text if it does not follow the grammar; InputError if there is no such column, and, when
///         evaluated, if an entry is no number. `rows` must outlive the expression.
GroupExpression parse_expression(const std::string& text, const JoinedRows& rows);
/// The same for what stands inside a statistic.
RowExpression parse_row_expression(const std::string& text, const JoinedRows& rows);

}  // namespace graincrack::summary
