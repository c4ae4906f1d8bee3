// A column of a table against another: a straight line or a power law, with 95 % intervals, for each group of rows.
#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "post/statistics/regression.hpp"
#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"

namespace graincrack {

struct TrendOptions {
    std::string x;                    ///< column
    std::string y;                    ///< column
    bool power = false;               ///< y = a x^b in place of y = a + b x
    std::vector<std::string> groups;  ///< columns; rows of equal entries are fitted together
};

/// The rows of one group, in the order of the tables.
struct TrendRows {
    std::string group;  ///< entries of the group columns, with commas between
    std::vector<double> x;
    std::vector<double> y;
    std::size_t left_out = 0;                  ///< rows with an empty x or y
    [[nodiscard]] std::size_t levels() const;  ///< different x
};
/// \param diagnostics receives a line if rows are left out, and one if the column peak_kind shows runs without a peak
/// \throws InputError for a missing column, a field that is no number, a power law through values that are not positive, or if
///         no group has two different x
std::vector<TrendRows> collect_trends(const std::vector<std::string>& tables, const TrendOptions& options,
                                      std::ostream& diagnostics);

/// Least squares; every row counts once, so that the weight of a level is its number of seeds. The intervals follow from the
/// scatter about the line: equal absolute errors (line) or equal relative ones (power law: a line through logarithms).
struct Trend {
    bool power = false;
    Line line;             ///< through logarithms for a power law
    Estimate coefficient;  ///< a: y at x = 0, or of a power law at x = 1
    Estimate slope;        ///< b: dy/dx, or the exponent
    /// d ln y/d ln x: the exponent, or b x/y at the mean of the rows. There its interval is Fieller's (1954), exact for a ratio
    /// of two normal values; empty if the mean of y does not differ significantly from zero.
    Estimate elasticity;
    double mean_x = 0;
    std::optional<LackOfFit> lack_of_fit;  ///< of the straight line, against the scatter at equal x
    /// The fitted y at an x with the 95 % interval of its mean.
    [[nodiscard]] Estimate at(double x) const;
};
/// Empty unless there are two different x. \pre x and y positive for a power law
std::optional<Trend> fit_trend(std::span<const double> x, std::span<const double> y, bool power);

/// Table `trend`: a row a group.
void write_trend_table(std::ostream& out, const std::vector<std::string>& tables, const TrendOptions& options, TableFormat format,
                       std::ostream& diagnostics);

}  // namespace graincrack
