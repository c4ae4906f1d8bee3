#include "post/claims/levels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace graincrack::claims {

namespace {

/// One row's entry of the claim's column.
std::optional<double> entry_of(const Claim& claim, const Rows& rows, std::size_t row) {
    const std::size_t minus = claim.column.find(" - ");
    if (minus != std::string::npos) {
        const auto first = rows.number(row, claim.column.substr(0, minus));
        const auto second = rows.number(row, claim.column.substr(minus + 3));
        if (!first || !second) return std::nullopt;
        return (*first - *second) * claim.factor;
    }
    if (claim.column.starts_with("x at ")) {
        const auto intercept = rows.number(row, "intercept");
        const auto slope = rows.number(row, "slope");
        const auto y = parse_number(claim.column.substr(5));
        if (!intercept || !slope || !y) return std::nullopt;
        return (*y - *intercept) / *slope * claim.factor;
    }
    const auto number = rows.number(row, claim.column);
    if (!number) return std::nullopt;
    return *number * claim.factor;
}

/// One row's entry with the interval of the claim's columns.
std::optional<Estimate> estimate_of_row(const Claim& claim, const Rows& rows, std::size_t row) {
    const auto value = entry_of(claim, rows, row);
    if (!value) return std::nullopt;
    Estimate estimate{*value, std::nullopt, std::nullopt};
    if (claim.interval.size() == 1) {
        if (const auto half = rows.number(row, claim.interval[0])) {
            estimate.low = *value - *half * claim.factor;
            estimate.high = *value + *half * claim.factor;
        }
    } else if (claim.interval.size() == 2) {
        const auto low = rows.number(row, claim.interval[0]);
        const auto high = rows.number(row, claim.interval[1]);
        if (low && high) {
            estimate.low = *low * claim.factor;
            estimate.high = *high * claim.factor;
        }
    }
    return estimate;
}

/// The part of rows that have an entry in a column.
Estimate part_filled(const Rows& rows, const std::string& column) {
    double filled = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) filled += rows.text(i, column).empty() ? 0 : 1;
    return {filled / static_cast<double>(rows.size()), std::nullopt, std::nullopt};
}

double tolerance_of(const Claim& claim) { return claim.tolerance.amount; }

/// The levels of a claim with the value of each specimen, by the entries of its pair column.
std::map<double, std::map<std::string, double>> values_by_level(const Claim& claim, const Rows& rows) {
    std::map<double, std::map<std::string, double>> levels;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto level = rows.number(i, claim.by);
        const auto value = entry_of(claim, rows, i);
        if (level && value) levels[*level][rows.text(i, claim.pair)] = *value;
    }
    return levels;
}

}  // namespace

Rows::Rows(const TableFile& table, const std::vector<Condition>& where) : table_(&table), rows_(table.n_rows()) {
    std::iota(rows_.begin(), rows_.end(), std::size_t{0});
    for (const Condition& condition : where) {
        if (condition.column == "row") continue;
        const std::vector<std::string> entries = table.texts(condition.column);
        std::erase_if(rows_, [&](std::size_t row) { return !meets(condition, entries[row]); });
    }
    for (const Condition& condition : where) {
        if (condition.column != "row") continue;
        const double place = parse_number(condition.value).value_or(0);
        if (place < 1 || place > static_cast<double>(rows_.size())) {
            rows_.clear();
        } else {
            rows_ = {rows_[static_cast<std::size_t>(place) - 1]};
        }
    }
}

std::string Rows::text(std::size_t row, const std::string& column) const { return table_->texts(column)[rows_[row]]; }

std::optional<double> Rows::number(std::size_t row, const std::string& column) const {
    const double value = table_->numbers_or_nan(column)[rows_[row]];
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

bool matches(const Condition& condition, const Rows& rows, std::size_t row) {
    return meets(condition, rows.text(row, condition.column));
}

std::vector<double> numbers_of(const Claim& claim, const Rows& rows) {
    std::vector<double> values;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (const auto value = entry_of(claim, rows, i)) values.push_back(*value);
    }
    return values;
}

std::optional<Estimate> estimate_of(const Claim& claim, const Rows& rows) {
    if (claim.column.starts_with("filled ")) return part_filled(rows, claim.column.substr(7));
    if (!claim.interval.empty() || rows.size() == 1) return estimate_of_row(claim, rows, 0);
    const std::vector<double> values = numbers_of(claim, rows);
    if (values.empty()) return std::nullopt;
    return sample(values).mean;
}

std::vector<std::pair<double, Estimate>> estimates_by_level(const Claim& claim, const Rows& rows) {
    std::vector<std::pair<double, Estimate>> levels;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto level = rows.number(i, claim.by);
        const auto estimate = estimate_of_row(claim, rows, i);
        if (level && estimate) levels.emplace_back(*level, *estimate);
    }
    std::stable_sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return levels;
}

std::optional<LevelDifference> difference_between_levels(const Claim& claim, const Rows& rows) {
    std::vector<Estimate> means;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (const auto estimate = estimate_of_row(claim, rows, i)) means.push_back(*estimate);
    }
    if (means.size() < 2) return std::nullopt;
    const Spread spread = judge_spread(means, tolerance_of(claim));
    return LevelDifference{{spread.relative, std::nullopt, std::nullopt}, spread.verdict};
}

std::optional<LevelDifference> difference_on_same_specimens(const Claim& claim, const Rows& rows) {
    const auto levels = values_by_level(claim, rows);
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
        const Verdict verdict = judge_value(off, 0, tolerance_of(claim));
        if (!out) out = LevelDifference{off, verdict};
        if (std::abs(off.value) > std::abs(out->largest.value)) out->largest = off;
        out->verdict = worse(out->verdict, verdict);
    }
    return out;
}

}  // namespace graincrack::claims
