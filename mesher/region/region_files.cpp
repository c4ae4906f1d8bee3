#include "mesher/region/region_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include "mesher/region/shapes.hpp"
#include "share/base/error.hpp"
#include "share/base/printable.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::size_t max_rows = 10'000;
constexpr std::size_t max_columns = 100;
constexpr double largest_mm = 1e7;  // as the largest specimen is wide
constexpr double mm = 1e-3;

/// The rows of a table, each with its line in the file.
class Table {
public:
    Table(const std::string& path, const std::vector<std::string>& needed) : path_(path) {
        std::ifstream file(path, std::ios::binary);
        if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
        std::size_t number = 0;
        for (std::string text; std::getline(file, text);) {
            ++number;
            if (!text.empty() && text.back() == '\r') text.pop_back();
            if (text.empty() || text[0] == '#') continue;
            add(number, text);
        }
        if (file.bad()) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
        for (const std::string& column : needed) {
            if (columns_.empty() || !has(column)) {
                throw InputError(
                    fmt::format("{}: no column {}; a header line with {} is needed", path, column, fmt::join(needed, ", ")));
            }
        }
        if (rows_.empty()) throw InputError(path + ": no rows below the header line");
    }

    [[nodiscard]] std::size_t n_rows() const { return rows_.size(); }
    [[nodiscard]] bool has(const std::string& column) const {
        return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
    }
    /// The text of a field, "" if there is no such column.
    [[nodiscard]] std::string text(std::size_t row, const std::string& column) const {
        const auto found = std::find(columns_.begin(), columns_.end(), column);
        return found == columns_.end() ? "" : rows_[row][static_cast<std::size_t>(found - columns_.begin())];
    }
    /// A length that stands in mm, in m.
    [[nodiscard]] double length(std::size_t row, const std::string& column) const {
        const std::string field = text(row, column);
        const char* const end = field.data() + field.size();
        double value = 0;
        const auto result = std::from_chars(field.data(), end, value);
        if (result.ec != std::errc{} || result.ptr != end || !(std::abs(value) <= largest_mm)) {
            throw InputError(
                fmt::format("{}: {} is \"{}\"; a number of mm is needed", where(row), column, printable(field.substr(0, 40))));
        }
        return value * mm;
    }
    /// "flaws.tsv: line 3".
    [[nodiscard]] std::string where(std::size_t row) const { return fmt::format("{}: line {}", path_, lines_[row]); }

private:
    void add(std::size_t number, const std::string& text) {
        if (text.find('\0') != std::string::npos) {
            throw InputError(path_ + ": is no text; a table with one header line is needed");
        }
        std::vector<std::string> fields;
        for (std::size_t from = 0;; from = text.find('\t', from) + 1) {
            fields.push_back(text.substr(from, text.find('\t', from) - from));
            if (text.find('\t', from) == std::string::npos) break;
            if (fields.size() == max_columns) {
                throw InputError(fmt::format("{}: line {}: more than {} fields", path_, number, max_columns));
            }
        }
        if (columns_.empty()) {
            columns_ = std::move(fields);
            return;
        }
        if (fields.size() != columns_.size()) {
            throw InputError(fmt::format("{}: line {} has {} fields, the header {}; fields are separated by tabs", path_, number,
                                         fields.size(), columns_.size()));
        }
        if (rows_.size() == max_rows) throw InputError(fmt::format("{}: more than {} rows", path_, max_rows));
        rows_.push_back(std::move(fields));
        lines_.push_back(number);
    }

    std::string path_;
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
    std::vector<std::size_t> lines_;
};

}  // namespace

Region read_polygon(const std::string& path) {
    const Table table(path, {"x_mm", "y_mm"});
    std::vector<Point> corners;
    std::vector<std::string> parts;
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        corners.push_back({table.length(row, "x_mm"), table.length(row, "y_mm")});
        parts.push_back(table.text(row, "part"));
        if (parts.back().find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-") != std::string::npos ||
            parts.back().size() > 40) {
            throw InputError(fmt::format("{}: part \"{}\" is no name; up to 40 of a-z, 0-9, _ and - are", table.where(row),
                                         printable(parts.back().substr(0, 40))));
        }
    }
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) throw InputError(path + ": a polygon needs three corners");
    Region region = polygon(std::move(corners), parts);
    try {
        check(region);
    } catch (const UsageError& error) {
        throw InputError(path + ": " + error.what());
    }
    return region;
}

std::vector<Hole> read_holes(const std::string& path) {
    const Table table(path, {"x_mm", "y_mm", "radius_mm"});
    std::vector<Hole> holes;
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        holes.push_back(
            {{table.length(row, "x_mm"), table.length(row, "y_mm")}, table.length(row, "radius_mm"), table.where(row)});
        if (!(holes.back().radius > 0)) throw InputError(holes.back().name + ": the radius must be above 0");
    }
    return holes;
}

std::vector<PrescribedEdge> read_flaws(const std::string& path) {
    const Table table(path, {"x1_mm", "y1_mm", "x2_mm", "y2_mm"});
    std::vector<PrescribedEdge> flaws;
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        PrescribedEdge flaw{{table.length(row, "x1_mm"), table.length(row, "y1_mm")},
                            {table.length(row, "x2_mm"), table.length(row, "y2_mm")},
                            {},
                            table.where(row)};
        const std::string contact_class = table.text(row, "class");
        const std::string state = table.text(row, "state");
        const auto kind = flaw_kind(contact_class, state);
        if (!kind) {
            throw InputError(fmt::format("{}: class \"{}\" in state \"{}\" is not understood; {}", flaw.name,
                                         printable(contact_class.substr(0, 40)), printable(state.substr(0, 40)), kinds_of_flaws));
        }
        flaw.kind = *kind;
        if (flaw.from == flaw.to) throw InputError(flaw.name + ": the flaw has no length");
        flaws.push_back(std::move(flaw));
    }
    return flaws;
}

}  // namespace graincrack::mesher
