#include "post/calibrate/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace graincrack::calibrate {

std::optional<double> relative_half_interval(std::span<const double> values) {
    const Sample all = sample(values);
    if (!all.mean.low) return std::nullopt;
    return (*all.mean.high - all.mean.value) / std::abs(all.mean.value);
}

std::size_t specimens_wanted(std::span<const double> values, const SamplingRule& rule) {
    const std::size_t n = values.size();
    if (n < rule.least) return std::min(rule.least, rule.most);
    const std::optional<double> half = relative_half_interval(values);
    if (n >= rule.most || (half && *half <= rule.width)) return n;
    const double needed = half ? static_cast<double>(n) * std::pow(*half / rule.width, 2) : 2.0 * static_cast<double>(n);
    const double most = static_cast<double>(rule.most);
    return std::max(n + 1, static_cast<std::size_t>(std::ceil(std::min(needed, most))));
}

std::optional<Bistable> find_bistable(std::span<const double> values, const std::vector<bool>& has_peak) {
    std::vector<double> with;
    std::vector<double> without;
    for (std::size_t i = 0; i < values.size(); ++i) (has_peak[i] ? with : without).push_back(values[i]);
    const std::size_t least = std::max<std::size_t>(3, values.size() / 10);
    if (with.size() < least || without.size() < least) return std::nullopt;
    const Sample a = sample(with);
    const Sample b = sample(without);
    const double error =
        std::hypot(*a.deviation / std::sqrt(static_cast<double>(a.n)), *b.deviation / std::sqrt(static_cast<double>(b.n)));
    const double difference = std::abs(a.mean.value - b.mean.value);
    const bool by_chance = difference <= student_t_95(static_cast<int>(values.size()) - 2) * error;
    if (by_chance || difference <= 0.1 * std::min(a.mean.value, b.mean.value)) return std::nullopt;
    return Bistable{a.mean.value, b.mean.value, a.n, b.n};
}

std::string label_of(const SamplingRule& rule) {
    return fmt::format("means of {} to {} specimens, until half of the 95 % interval is within {:g} %", rule.least, rule.most,
                       100 * rule.width);
}

}  // namespace graincrack::calibrate
