#include "post/claims/verdict.hpp"

#include <algorithm>
#include <cmath>

namespace graincrack::claims {

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::holds: return "holds";
        case Verdict::differs: return "differs";
        default: return "open";
    }
}

std::optional<double> half_interval(const Estimate& ours) {
    if (!ours.low || !ours.high) return std::nullopt;
    return (*ours.high - *ours.low) / 2;
}

Verdict judge_value(const Estimate& ours, double claimed, double tolerance) {
    const std::optional<double> half = half_interval(ours);
    const double off = std::abs(ours.value - claimed);
    if (off <= tolerance) return !half || *half <= tolerance ? Verdict::holds : Verdict::open;
    return half && off - *half <= tolerance ? Verdict::open : Verdict::differs;
}

Verdict judge_covered(const Estimate& ours, double claimed, double max_width) {
    if (!ours.low || !ours.high) return Verdict::open;
    if (*ours.low > claimed || *ours.high < claimed) return Verdict::differs;
    return *ours.high - *ours.low > max_width ? Verdict::open : Verdict::holds;
}

Verdict judge_sign(const Estimate& ours, bool positive) {
    if (!ours.low || !ours.high) return Verdict::open;
    if (*ours.low > 0) return positive ? Verdict::holds : Verdict::differs;
    if (*ours.high < 0) return positive ? Verdict::differs : Verdict::holds;
    return Verdict::open;
}

bool Bound::met_by(double number) const {
    if (number == value) return or_equal;
    return above == (number > value);
}

Verdict judge_order(const Estimate& ours, const Bound& bound) {
    const std::optional<double> half = half_interval(ours);
    if (half && std::abs(ours.value - bound.value) < *half) return Verdict::open;
    return bound.met_by(ours.value) ? Verdict::holds : Verdict::differs;
}

Verdict judge_change(const Estimate& from, const Estimate& to, bool rises) {
    const std::optional<double> first = half_interval(from);
    const std::optional<double> second = half_interval(to);
    if (!first || !second) return Verdict::open;
    const double change = to.value - from.value;
    if (std::abs(change) < std::hypot(*first, *second)) return Verdict::open;
    return change != 0 && (change > 0) == rises ? Verdict::holds : Verdict::differs;
}

Spread judge_spread(std::span<const Estimate> means, double tolerance) {
    const auto less = [](const Estimate& a, const Estimate& b) { return a.value < b.value; };
    const Estimate& least = *std::min_element(means.begin(), means.end(), less);
    // The first of equal ones, as for the smallest: their intervals may differ.
    const Estimate& most = *std::max_element(means.begin(), means.end(), less);
    const double noise = std::hypot(half_interval(least).value_or(0), half_interval(most).value_or(0)) / least.value;
    const double spread = most.value / least.value - 1;
    if (spread < tolerance) return {spread, Verdict::holds};
    return {spread, spread - noise < tolerance ? Verdict::open : Verdict::differs};
}

Verdict worse(Verdict a, Verdict b) { return std::max(a, b); }

}  // namespace graincrack::claims
