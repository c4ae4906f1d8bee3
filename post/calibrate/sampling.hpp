// How many specimens a mean needs: sampling until its interval is narrow enough.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "post/fit/statistics.hpp"

namespace graincrack::calibrate {

/// A mean is taken from `least` specimens and on until half of its 95 % interval is within `width` (a part of the mean), or from
/// `most`.
struct SamplingRule {
    std::size_t least = 10;
    std::size_t most = 80;
    double width = 0.03;
};

/// The number of specimens to have next: as many as there are, if the rule is met; else what the deviation of these asks for.
/// \pre values is not empty
std::size_t specimens_wanted(std::span<const double> values, const SamplingRule& rule);

/// Half of the 95 % interval over the mean; empty for one value.
std::optional<double> relative_half_interval(std::span<const double> values);

/// Two kinds of results at one point: some tests fall behind their peak, others harden up to the strain limit.
struct Bistable {
    double mean_with_peak = 0;
    double mean_without_peak = 0;
    std::size_t with_peak = 0;
    std::size_t without_peak = 0;
};
/// Recognised where either kind has three tests and a tenth of all, and their means differ by more than a tenth and by more than
/// chance (two-sided t test, 95 %). \param has_peak of each value
std::optional<Bistable> find_bistable(std::span<const double> values, const std::vector<bool>& has_peak);

/// "means of 10 to 80 specimens, until half of the 95 % interval is within 3 %"
std::string label_of(const SamplingRule& rule);

}  // namespace graincrack::calibrate
