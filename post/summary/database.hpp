// Tables in memory that are read by SQL, on SQLite.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "post/table/table.hpp"

struct sqlite3;

namespace graincrack::summary {

/// The rows of a query.
struct Answer {
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows;
};

/// A table a name. Entries that are numbers are real numbers, empty ones are NULL, others are texts.
class Database {
public:
    /// \param files NAME=FILE, or FILE, whose stem is the name, with _ for what is neither letter nor digit; "-" is `stdin`.
    /// Files of one name make one table: their rows one behind the other, NULL in columns that only others have.
    /// \param label empty, or a column that is added to every table: the stem of the file of the row
    /// \throws InputError if a file cannot be read, has a column twice or a column `label`
    Database(const std::vector<std::string>& files, const std::string& label);

    /// Names of the tables, in the order of the files.
    [[nodiscard]] const std::vector<std::string>& tables() const { return tables_; }

    /// \param name of the query, for messages \param settings values of :NAME in it
    /// \throws UsageError for what is no query, a :NAME without a value or a value without :NAME; InputError for a text where a
    ///         number is needed
    [[nodiscard]] Answer query(const std::string& sql, const std::string& name,
                               const std::map<std::string, std::string>& settings) const;

private:
    std::shared_ptr<sqlite3> database_;
    std::vector<std::string> tables_;
    std::map<std::string, std::vector<std::string>> columns_;
};

}  // namespace graincrack::summary
