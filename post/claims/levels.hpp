// Rows of a table that a claim selects, and estimates from them: of one row, over rows, by level.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "post/claims/claim.hpp"
#include "post/statistics/statistics.hpp"
#include "post/summary/database.hpp"

namespace graincrack::claims {

/// What a claim takes from a row of its table. What is empty there, or has no column in the claim, is empty.
struct Row {
    std::optional<Estimate> ours;  ///< in the unit of the paper, with the interval of the claim's columns
    std::optional<double> level;
    std::string specimen;
    std::optional<double> paper;  ///< where `value` of the claim is a column
    bool meets_needs = true;
    std::string without_peak;  ///< " (3 of 10 without a peak)" of a row that counts them
};

/// The rows of a claim. \throws InputError that begins with `where` for a table, column or condition that cannot be understood
std::vector<Row> rows_of(const Claim& claim, const summary::Database& tables, const std::string& where);

/// The entries that there are, in the unit of the paper.
std::vector<double> numbers_of(const std::vector<Row>& rows);

/// Our number: of one row with the interval of the claim's columns, or the mean over rows with Student's interval. Empty without
/// an entry.
std::optional<Estimate> estimate_of(const Claim& claim, const std::vector<Row>& rows);

/// The same at each level, by rising level; rows need the interval columns of the claim, without them levels have none.
std::vector<std::pair<double, Estimate>> estimates_by_level(const std::vector<Row>& rows);

/// How much the levels differ.
struct LevelDifference {
    Estimate largest;  ///< a part
    Verdict verdict = Verdict::open;
};
/// The largest of the means at the levels over the smallest, against the tolerance. Empty for fewer than two levels.
std::optional<LevelDifference> difference_between_levels(const Claim& claim, const std::vector<Row>& rows);
/// At each level the mean ratio to the base on the same specimens, which must be 1 within the tolerance at each of them. The base
/// is the level nearest to 1. Empty for fewer than two levels.
std::optional<LevelDifference> difference_on_same_specimens(const Claim& claim, const std::vector<Row>& rows);

}  // namespace graincrack::claims
