// Verdicts on a claim: pure functions of our number, its interval and what is claimed.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "post/statistics/statistics.hpp"

namespace graincrack::claims {

/// holds and differs are decided by the numbers; open: the interval is too wide for either, or there is no number.
enum class Verdict { holds, open, differs };
/// "holds", "open", "differs".
std::string_view name_of(Verdict verdict);

/// Half of the interval of an estimate; empty without an interval.
std::optional<double> half_interval(const Estimate& ours);

/// A number against a claimed one. Within the tolerance (absolute) it holds if half of its interval is no wider than the
/// tolerance, otherwise it is open; outside it differs, or is open if the interval reaches into the tolerance. Without an
/// interval the number alone counts.
Verdict judge_value(const Estimate& ours, double claimed, double tolerance);

/// Whether the claimed number lies in our interval. Open without an interval, or if one that holds it is wider than `max_width`.
Verdict judge_covered(const Estimate& ours, double claimed, double max_width);

/// Whether the number is above zero (or below it): the whole interval must be. Open without an interval.
Verdict judge_sign(const Estimate& ours, bool positive);

/// A bound that a number must not pass.
struct Bound {
    double value = 0;
    bool above = true;     ///< the number must lie above it
    bool or_equal = true;  ///< reaching it suffices
    [[nodiscard]] bool met_by(double number) const;
};
/// Open if the interval holds the bound; without an interval the number alone counts.
Verdict judge_order(const Estimate& ours, const Bound& bound);

/// Whether a quantity rises (or falls) from one mean to another: by more than both half intervals together, √(h₁² + h₂²). Open if
/// the change is smaller, or a half interval is missing.
Verdict judge_change(const Estimate& from, const Estimate& to, bool rises);

/// Whether the largest of several means exceeds the smallest by less than the tolerance, a part of the smallest. Outside of it,
/// open if √(h₁² + h₂²) of these two reaches into it. A mean without an interval counts as exact.
struct Spread {
    double relative = 0;  ///< largest over smallest − 1
    Verdict verdict = Verdict::open;
};
/// \pre two means or more
Spread judge_spread(std::span<const Estimate> means, double tolerance);

/// The worst of two: differs before open before holds.
Verdict worse(Verdict a, Verdict b);

}  // namespace graincrack::claims
