// Texts with numbers of a group in them, as a table of results shows them: "{mean(A):.1f} ± {half_interval(A):.1f}".
//
//     {EXPRESSION:FORMAT}              a number, in the format of fmt: .1f, +.2f, .0e
//     {EXPRESSION}                     with seven digits
//     {COLUMN}, {COLUMN where A=b}     the entries of a column that are not empty, each once, with "; " between them
//     [{A:.1f} ± {B:.1f};{A:.1f}]      the first of these in which nothing is empty; "-" if there is none
//
// What is empty outside of [] is "-".
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "post/summary/joined_rows.hpp"

namespace graincrack::summary {

/// A text from the rows of a group, by their places in the table.
using TextTemplate = std::function<std::string(const std::vector<std::size_t>&)>;

/// \throws UsageError that quotes what is wrong; InputError as of parse_expression. `rows` must outlive the template.
TextTemplate parse_template(const std::string& text, const JoinedRows& rows);

}  // namespace graincrack::summary
