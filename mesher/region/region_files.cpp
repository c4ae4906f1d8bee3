#include "mesher/region/region_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "mesher/plane/triangulation.hpp"
#include "mesher/region/shapes.hpp"
#include "share/base/error.hpp"
#include "share/base/table_file.hpp"
#include "share/base/text.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::size_t max_rows = 10'000;
constexpr double largest_mm = 1e7;  // width of the largest specimen
constexpr double mm = 1e-3;

TableFile read_table(const std::string& path, const std::vector<std::string>& needed) {
    TableFile table(path);
    for (const std::string& column : needed) {
        if (table.has(column)) continue;
        throw InputError(fmt::format("{}: no column {}; a header line with {} is needed", path, column, fmt::join(needed, ", ")));
    }
    if (table.n_rows() > max_rows) throw InputError(fmt::format("{}: more than {} rows", path, max_rows));
    return table;
}

/// Converts a length in mm to m.
double length(const TableFile& table, std::size_t row, const std::string& column) {
    const double value = table.number(row, column);
    if (!(std::abs(value) <= largest_mm)) {
        throw InputError(fmt::format("{}: {} is \"{}\"; a number of mm is needed", table.where(row), column,
                                     printable(table.text(row, column).substr(0, 40))));
    }
    return value * mm;
}

}  // namespace

Region read_polygon(const std::string& path) {
    const TableFile table = read_table(path, {"x_mm", "y_mm"});
    std::vector<Point> corners;
    std::vector<std::string> parts;
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        corners.push_back({length(table, row, "x_mm"), length(table, row, "y_mm")});
        parts.push_back(table.text(row, "part"));
        if (parts.back().find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-") != std::string::npos ||
            parts.back().size() > 40) {
            throw InputError(fmt::format("{}: part \"{}\" is no name; up to 40 of a-z, 0-9, _ and - are", table.where(row),
                                         printable(parts.back().substr(0, 40))));
        }
    }
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) throw InputError(path + ": a polygon needs three corners");
    if (!is_simple(corners)) throw InputError(path + ": sides of the polygon cross, touch or lie upon each other");
    return polygon(std::move(corners), parts);
}

std::vector<Hole> read_holes(const std::string& path) {
    const TableFile table = read_table(path, {"x_mm", "y_mm", "radius_mm"});
    std::vector<Hole> holes;
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        holes.push_back(
            {{length(table, row, "x_mm"), length(table, row, "y_mm")}, length(table, row, "radius_mm"), table.where(row)});
        if (!(holes.back().radius > 0)) throw InputError(holes.back().name + ": the radius must be above 0");
    }
    return holes;
}

std::vector<PrescribedEdge> read_flaws(const std::string& path) {
    const TableFile table = read_table(path, {"x1_mm", "y1_mm", "x2_mm", "y2_mm"});
    std::vector<PrescribedEdge> flaws;
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        PrescribedEdge flaw{{length(table, row, "x1_mm"), length(table, row, "y1_mm")},
                            {length(table, row, "x2_mm"), length(table, row, "y2_mm")},
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
