// Rows of a table that a claim selects, and estimates from them: of one row, over rows, by level.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "post/claims/claim.hpp"
#include "post/table/table_file.hpp"

namespace graincrack::claims {

/// Rows of a table that meet conditions. The condition row=N selects the N-th of those that meet the others.
class Rows {
public:
    Rows(const TableFile& table, const std::vector<Condition>& where);
    [[nodiscard]] std::size_t size() const { return rows_.size(); }
    [[nodiscard]] bool has(const std::string& column) const { return table_->has(column); }
    [[nodiscard]] std::string text(std::size_t row, const std::string& column) const;
    /// Empty if the entry is. \throws InputError if it is no number
    [[nodiscard]] std::optional<double> number(std::size_t row, const std::string& column) const;

private:
    const TableFile* table_;
    std::vector<std::size_t> rows_;
};

/// Whether a row meets a condition. Numbers are compared as numbers.
bool matches(const Condition& condition, const Rows& rows, std::size_t row);

/// The column of a claim in every row that has an entry, in the paper's unit: a column, or "A - B".
std::vector<double> numbers_of(const Claim& claim, const Rows& rows);

/// Our number: of one row with the interval of the claim's columns, or the mean over rows with Student's interval. Empty without
/// an entry.
std::optional<Estimate> estimate_of(const Claim& claim, const Rows& rows);

/// The same at each level, by rising level; rows need the interval columns of the claim, without them levels have none.
std::vector<std::pair<double, Estimate>> estimates_by_level(const Claim& claim, const Rows& rows);

/// How much the levels differ.
struct LevelDifference {
    Estimate largest;  ///< a part
    Verdict verdict = Verdict::open;
};
/// The largest of the means at the levels over the smallest, against the tolerance. Empty for fewer than two levels.
std::optional<LevelDifference> difference_between_levels(const Claim& claim, const Rows& rows);
/// At each level the mean ratio to the base on the same specimens, which must be 1 within the tolerance at each of them. The base
/// is the level nearest to 1. Empty for fewer than two levels.
std::optional<LevelDifference> difference_on_same_specimens(const Claim& claim, const Rows& rows);

}  // namespace graincrack::claims
