// Statistics of the rows of tables by groups: the command `summarize`.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/table/table.hpp"

namespace graincrack::summary {

struct SummaryOptions {
    std::vector<std::string> by;       ///< COLUMN or NAME=EXPRESSION of a row, whose entries make the groups; none: one group
    std::string join;                  ///< a column by which the rows of the tables become one; empty: they stay apart
    std::vector<std::string> where;    ///< conditions on rows; all must hold
    std::vector<std::string> columns;  ///< NAME=EXPRESSION, or NAME=TEMPLATE with {
    bool sort = false;                 ///< groups by rising entries, numbers as numbers; else as they come first
    TableFormat format = TableFormat::tsv;
    std::string label = {};                 ///< a column that is added: tables are LABEL=FILE; empty: they are files
    std::vector<std::string> look_up = {};  ///< tables whose columns are added to rows with the same entry in their first column
};

/// Writes one row a group: the columns `by`, then `columns`.
/// \throws UsageError for an option that cannot be understood, InputError for a table or an entry
void write_summary(std::ostream& out, const std::vector<std::string>& files, const SummaryOptions& options);

}  // namespace graincrack::summary
