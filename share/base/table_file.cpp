#include "share/base/table_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {

TableFile::TableFile(const std::string& path) : name_(path == "-" ? "stdin" : path) {
    std::istringstream stream(path == "-" ? text_of_stream(std::cin, name_) : text_of_file(path));
    char separator = '\t';
    std::size_t line_number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++line_number;
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty() || line[0] == '#') continue;
        if (line.find('\0') != std::string::npos) {
            throw InputError(name_ + ": is no text; a table with one header line is needed");
        }
        if (columns_.empty()) {
            separator = line.find('\t') == std::string::npos && line.find(',') != std::string::npos ? ',' : '\t';
            const auto names = split(line, separator);
            columns_.assign(names.begin(), names.end());
            continue;
        }
        const auto fields = split(line, separator);
        rows_.emplace_back(fields.begin(), fields.end());
        lines_.push_back(line_number);
        if (rows_.back().size() != columns_.size()) {
            throw InputError(fmt::format("{}: line {} has {} fields, the header {}; a table has equally many in every row", name_,
                                         line_number, rows_.back().size(), columns_.size()));
        }
    }
    if (line_number == 0 && path == "-") throw InputError("stdin: empty: the program before wrote nothing; see its message");
    if (rows_.empty()) throw InputError(name_ + ": no rows; a table with one header line and rows is needed");
}

bool TableFile::has(const std::string& column) const {
    return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::size_t TableFile::index(const std::string& column) const {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found == columns_.end()) {
        throw InputError(fmt::format("{}: no column {}; there are {}", name_, column, fmt::join(columns_, ", ")));
    }
    return static_cast<std::size_t>(found - columns_.begin());
}

double TableFile::number(std::size_t row, const std::string& name) const {
    const std::size_t column = index(name);
    const std::string& text = rows_[row][column];
    if (text.empty()) return std::numeric_limits<double>::quiet_NaN();
    const char* from = text.data() + (text[0] == '+' ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(from, text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
        throw InputError(fmt::format("{}: {} is \"{}\"; a number is needed", where(row), columns_[column], text));
    }
    return value;
}

std::vector<double> TableFile::numbers_or_nan(const std::string& column) const {
    std::vector<double> values(rows_.size());
    for (std::size_t row = 0; row < rows_.size(); ++row) values[row] = number(row, column);
    return values;
}

std::vector<double> TableFile::numbers(const std::string& column) const {
    std::vector<double> values = numbers_or_nan(column);
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (std::isnan(values[row])) throw InputError(fmt::format("{}: {} is empty; a number is needed", where(row), column));
    }
    return values;
}

std::string TableFile::text(std::size_t row, const std::string& column) const {
    return has(column) ? rows_[row][index(column)] : "";
}

std::string TableFile::where(std::size_t row) const { return fmt::format("{}: line {}", name_, lines_[row]); }

std::vector<std::string> TableFile::texts(const std::string& column) const {
    const std::size_t at = index(column);
    std::vector<std::string> out;
    for (const auto& row : rows_) out.push_back(row[at]);
    return out;
}

}  // namespace graincrack
