// Rows of several tables, taken together.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "post/table/table_file.hpp"

namespace graincrack::summary {

/// How the rows of tables are taken together.
struct Joining {
    /// Empty, or a column: rows of later tables are joined to the first row with the same entry in it, and fill only what is
    /// empty there.
    std::string join;
    /// Empty, or a column that is added: its entry in the rows of each table is that of `labels`, one for each table.
    std::string label;
    std::vector<std::string> labels;
};

/// The rows of all tables one behind the other. A column that only some tables have is empty in the rows of the others.
class JoinedRows {
public:
    /// \throws InputError if a table has no column `join`, or has the column `label` already
    JoinedRows(const std::vector<TableFile>& tables, const Joining& joining);
    /// Adds the other columns of a table to each row that has the same entry in the first column of that table; a row with
    /// several partners there becomes as many rows, one without any keeps these columns empty. \throws InputError if the rows
    /// have no such first column, or have one of the others already
    void look_up(const TableFile& table);
    [[nodiscard]] std::size_t size() const { return size_; }
    /// The entries of a column. \throws InputError if no table has it
    [[nodiscard]] const std::vector<std::string>& column(const std::string& name) const;

private:
    void add(const TableFile& table, const std::vector<std::size_t>& places);

    std::map<std::string, std::vector<std::string>> columns_;
    std::size_t size_ = 0;
    std::string names_;  ///< of the tables, for messages
};

}  // namespace graincrack::summary
