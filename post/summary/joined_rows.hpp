// Rows of several tables, taken together.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "post/table/table_file.hpp"

namespace graincrack::summary {

/// The rows of all tables one behind the other. A column that only some tables have is empty in the rows of the others.
class JoinedRows {
public:
    /// \param join empty, or a column: rows of later tables are joined to the first row with the same entry in it, and fill only
    ///        what is empty there. \throws InputError if a table has no such column
    JoinedRows(const std::vector<TableFile>& tables, const std::string& join);
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
