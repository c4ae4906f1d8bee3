// Strengths of slow loading: the same tests at two rates, extrapolated to none.
#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// A strength that is linear in the rate, at the limit of slow loading.
struct RateLimit {
    Estimate change;   ///< of the mean at the faster rate against that at the slower one, relative; interval of paired changes
    double limit = 0;  ///< mean strength without a rate, Pa
    /// The larger of what the limit differs from the slower rate by, and of the half interval of that: the former is as much as a
    /// dependence that is not linear can put wrong unless it changes its sign. Pa
    double error = 0;
};
/// \param fast strengths of specimens, Pa \param slow of the same specimens at a slower rate
/// \param ratio of the faster rate over the slower, above 1
RateLimit extrapolate_rate(std::span<const double> fast, std::span<const double> slow, double ratio);

/// Table `strength --extrapolate`, a row for each test, pressure and strength (largest; first peak where all runs have one).
/// \param runs the tests of some specimens at two rates each, in any order
/// \throws InputError if a test has no partner at another rate or more
///        than one, differs from it in more than the rate, or differs from it by more than 5 % in the mean
void write_rate_limits(std::ostream& out, const std::vector<std::string>& runs, TableFormat format);

}  // namespace graincrack
