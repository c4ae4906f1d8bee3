// Reads tables from TSV or comma-separated files with one header line. Lines that begin with # are skipped.
#pragma once

#include <string>
#include <vector>

namespace graincrack {

class TableFile {
public:
    /// \param path a file or "-" \throws InputError if it cannot be read or a row does not have as many fields as the header
    explicit TableFile(const std::string& path);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
    [[nodiscard]] std::size_t n_rows() const { return rows_.size(); }
    [[nodiscard]] bool has(const std::string& column) const;

    /// A column of numbers. \throws InputError if it is missing, a field is no number, or one is empty
    [[nodiscard]] std::vector<double> numbers(const std::string& column) const;
    /// Does the same with NaN for empty fields.
    [[nodiscard]] std::vector<double> numbers_or_nan(const std::string& column) const;
    /// A column as text. \throws InputError if it is missing
    [[nodiscard]] std::vector<std::string> texts(const std::string& column) const;

    /// A number; NaN for an empty field. \throws InputError if the column is missing or the field is no number
    [[nodiscard]] double number(std::size_t row, const std::string& column) const;
    /// The text of a field, "" if there is no such column.
    [[nodiscard]] std::string text(std::size_t row, const std::string& column) const;
    /// The place of a row for messages: "flaws.tsv: line 3".
    [[nodiscard]] std::string where(std::size_t row) const;

private:
    [[nodiscard]] std::size_t index(const std::string& column) const;

    std::string name_;
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
    std::vector<std::size_t> lines_;  ///< [rows] line in the file, for messages
};

}  // namespace graincrack
