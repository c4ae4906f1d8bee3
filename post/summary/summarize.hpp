// Runs a query of tables: the command `summarize`.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/table/table.hpp"

namespace graincrack::summary {

struct SummaryOptions {
    std::string sql = {};                    ///< query, or file *.sql with it; empty: the first table unchanged
    std::vector<std::string> settings = {};  ///< NAME=VALUE, the value of :NAME in the query
    std::string label = {};                  ///< additional column of every table with the stem of the row's file
    /// The last two columns of the query are a name and a value. Rows with equal preceding columns become one row with a column
    /// for each name, in the order of their first occurrence.
    bool pivot = false;
};

/// Writes the rows of a query of the tables. \param files NAME=FILE or FILE, see `Database`
/// \throws UsageError for an invalid query or option, InputError for a table or an entry
void write_summary(std::ostream& out, const std::vector<std::string>& files, const SummaryOptions& options,
                   TableFormat format = TableFormat::tsv);

}  // namespace graincrack::summary
