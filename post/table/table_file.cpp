#include "post/table/table_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>

#include "share/base/error.hpp"

namespace graincrack {

namespace {

std::vector<std::string> fields(std::string line, char separator) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::vector<std::string> out;
    std::size_t from = 0;
    for (std::size_t at = line.find(separator); at != std::string::npos; at = line.find(separator, from)) {
        out.push_back(line.substr(from, at - from));
        from = at + 1;
    }
    out.push_back(line.substr(from));
    return out;
}

}  // namespace

TableFile::TableFile(const std::string& path) : name_(path == "-" ? "stdin" : path) {
    std::ifstream file;
    if (path != "-") {
        file.open(path, std::ios::binary);
        if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    }
    std::istream& stream = path == "-" ? std::cin : file;
    char separator = '\t';
    std::size_t line_number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++line_number;
        if (line.empty() || line == "\r" || line[0] == '#') continue;
        if (line.find('\0') != std::string::npos) {
            throw InputError(name_ + ": is no text; a table with one header line is needed");
        }
        if (columns_.empty()) {
            separator = line.find('\t') == std::string::npos && line.find(',') != std::string::npos ? ',' : '\t';
            columns_ = fields(line, separator);
            continue;
        }
        rows_.push_back(fields(line, separator));
        lines_.push_back(line_number);
        if (rows_.back().size() != columns_.size()) {
            throw InputError(fmt::format("{}: line {} has {} fields, the header {}; a table has equally many in every row", name_,
                                         line_number, rows_.back().size(), columns_.size()));
        }
    }
    if (line_number == 0 && path == "-") throw InputError("stdin: empty: the program before wrote nothing; see its message");
    if (rows_.empty()) throw InputError(name_ + ": no rows; a table with one header line and rows of numbers is needed");
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

double TableFile::number(std::size_t row, std::size_t column) const {
    const std::string& text = rows_[row][column];
    if (text.empty()) return std::numeric_limits<double>::quiet_NaN();
    const char* from = text.data() + (text[0] == '+' ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(from, text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
        throw InputError(
            fmt::format("{}: line {}: {} is \"{}\"; a number is needed", name_, lines_[row], columns_[column], text));
    }
    return value;
}

std::vector<double> TableFile::numbers_or_nan(const std::string& column) const {
    const std::size_t at = index(column);
    std::vector<double> values(rows_.size());
    for (std::size_t row = 0; row < rows_.size(); ++row) values[row] = number(row, at);
    return values;
}

std::vector<double> TableFile::numbers(const std::string& column) const {
    std::vector<double> values = numbers_or_nan(column);
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (std::isnan(values[row])) {
            throw InputError(fmt::format("{}: line {}: {} is empty; a number is needed", name_, lines_[row], column));
        }
    }
    return values;
}

std::vector<std::string> TableFile::texts(const std::string& column) const {
    const std::size_t at = index(column);
    std::vector<std::string> out;
    for (const auto& row : rows_) out.push_back(row[at]);
    return out;
}

}  // namespace graincrack
