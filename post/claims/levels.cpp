#include "post/claims/levels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "post/table/number.hpp"
#include "share/base/error.hpp"

namespace graincrack::claims {

namespace {

/// A text for tests without a peak, where the table counts them.
std::string without_peak(const summary::Database& tables, const std::string& table) {
    const std::string total = tables.has(table, "specimens") ? "specimens" : "runs";
    if (!tables.has(table, "without_peak") || !tables.has(table, total)) return "";
    return fmt::format("iif(without_peak > 0, text(' ({{}} of {{}} without a peak)', without_peak, {}), NULL)", total);
}

/// The levels of a claim with the value of each specimen.
std::map<double, std::map<std::string, double>> values_by_level(const std::vector<Row>& rows) {
    std::map<double, std::map<std::string, double>> levels;
    for (const Row& row : rows) {
        if (row.level && row.ours) levels[*row.level][row.specimen] = row.ours->value;
    }
    return levels;
}

}  // namespace

std::vector<Row> rows_of(const Claim& claim, const summary::Database& tables, const std::string& where) {
    std::vector<std::string> interval = claim.interval;
    interval.resize(2);
    if (claim.interval.size() == 1) {
        const std::string half = claim.interval[0];
        interval = {claim.column + " - " + half, claim.column + " + " + half};
    }
    const bool has_levels = claim.kind == Kind::trend || !claim.pair.empty();
    std::vector<std::string> parts{claim.column, interval[0],
                                   interval[1],  has_levels ? claim.by : "",
                                   claim.pair,   claim.value.starts_with('=') ? claim.value.substr(1) : "",
                                   claim.needs,  without_peak(tables, claim.table)};
    for (std::string& part : parts) part = part.empty() ? "NULL" : "(" + part + ")";
    const std::string sql = fmt::format("SELECT {} FROM {} WHERE {}", fmt::join(parts, ", "), claim.table,
                                        claim.where.empty() ? "TRUE" : claim.where);
    std::vector<Row> rows;
    for (const std::vector<Cell>& cells : tables.answer_of_file(sql, where)) {
        const auto number = [&](std::size_t place) -> std::optional<double> {
            const std::string& text = cells[place].text();
            if (text.empty()) return std::nullopt;
            if (const auto value = parse_number(text)) return value;
            throw InputError(fmt::format("{}: \"{}\"; a number is needed", where, text));
        };
        const auto ours = [&](std::size_t place) {
            const auto value = number(place);
            return value ? std::optional(*value * claim.factor) : std::nullopt;
        };
        Row& row = rows.emplace_back();
        if (const auto value = ours(0)) row.ours = Estimate{*value, ours(1), ours(2)};
        row.level = number(3);
        row.specimen = cells[4].text();
        row.paper = number(5);
        row.meets_needs = claim.needs.empty() || number(6).value_or(0) != 0;
        row.without_peak = cells[7].text();
    }
    return rows;
}

std::vector<double> numbers_of(const std::vector<Row>& rows) {
    std::vector<double> values;
    for (const Row& row : rows) {
        if (row.ours) values.push_back(row.ours->value);
    }
    return values;
}

std::optional<Estimate> estimate_of(const Claim& claim, const std::vector<Row>& rows) {
    if (!claim.interval.empty() || rows.size() == 1) return rows.front().ours;
    const std::vector<double> values = numbers_of(rows);
    if (values.empty()) return std::nullopt;
    return sample(values).mean;
}

std::vector<std::pair<double, Estimate>> estimates_by_level(const std::vector<Row>& rows) {
    std::vector<std::pair<double, Estimate>> levels;
    for (const Row& row : rows) {
        if (row.level && row.ours) levels.emplace_back(*row.level, *row.ours);
    }
    std::stable_sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return levels;
}

std::optional<LevelDifference> difference_between_levels(const Claim& claim, const std::vector<Row>& rows) {
    std::vector<Estimate> means;
    for (const Row& row : rows) {
        if (row.ours) means.push_back(*row.ours);
    }
    if (means.size() < 2) return std::nullopt;
    const Spread spread = judge_spread(means, claim.tolerance.amount);
    return LevelDifference{{spread.relative, std::nullopt, std::nullopt}, spread.verdict};
}

std::optional<LevelDifference> difference_on_same_specimens(const Claim& claim, const std::vector<Row>& rows) {
    const auto levels = values_by_level(rows);
    if (levels.size() < 2) return std::nullopt;
    const auto base = std::min_element(
        levels.begin(), levels.end(), [](const auto& a, const auto& b) { return std::abs(a.first - 1) < std::abs(b.first - 1); });
    std::optional<LevelDifference> out;
    for (auto level = levels.begin(); level != levels.end(); ++level) {
        if (level == base) continue;
        std::vector<double> ratios;
        for (const auto& [specimen, value] : level->second) {
            const auto other = base->second.find(specimen);
            if (other != base->second.end()) ratios.push_back(value / other->second - 1);
        }
        if (ratios.empty()) continue;
        const Estimate off = sample(ratios).mean;
        const Verdict verdict = judge_value(off, 0, claim.tolerance.amount);
        if (!out) out = LevelDifference{off, verdict};
        if (std::abs(off.value) > std::abs(out->largest.value)) out->largest = off;
        out->verdict = worse(out->verdict, verdict);
    }
    return out;
}

}  // namespace graincrack::claims
