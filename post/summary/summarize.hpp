// A query of tables: the command `summarize`.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/table/table.hpp"

namespace graincrack::summary {

struct SummaryOptions {
    std::string sql = {};                    ///< a query, or a file *.sql that has it; empty: the first table as it is
    std::vector<std::string> settings = {};  ///< NAME=VALUE, for :NAME in the query
    std::string label = {};                  ///< a column that every table has in addition: the stem of the file of the row
    /// The last two columns of the query are a name and a value: rows alike in the columns before become one, with a column for
    /// each name, in the order in which they first come.
    bool pivot = false;
};

/// Writes the rows of a query of the tables. \param files NAME=FILE or FILE, as `Database` takes them
/// \throws UsageError for a query or an option that cannot be understood, InputError for a table or an entry
void write_summary(std::ostream& out, const std::vector<std::string>& files, const SummaryOptions& options,
                   TableFormat format = TableFormat::tsv);

}  // namespace graincrack::summary
