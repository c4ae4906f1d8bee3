#include "post/statistics/statistics.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <gsl/gsl_sort.h>
#include <algorithm>
#include <cmath>
#include <vector>

namespace graincrack {

double student_t_95(int degrees_of_freedom) { return gsl_cdf_tdist_Pinv(0.975, degrees_of_freedom); }

Estimate estimate(double value, double variance, int degrees_of_freedom) {
    if (degrees_of_freedom < 1) return {value, std::nullopt, std::nullopt};
    const double half = student_t_95(degrees_of_freedom) * std::sqrt(std::max(variance, 0.0));
    return {value, value - half, value + half};
}

Sample sample(std::span<const double> values) {
    const std::size_t n = values.size();
    if (n == 0) return {0, {std::nan(""), std::nullopt, std::nullopt}, std::nullopt};
    Sample s{n, {gsl_stats_mean(values.data(), 1, n), std::nullopt, std::nullopt}, std::nullopt};
    if (n < 2) return s;
    s.deviation = gsl_stats_sd_m(values.data(), 1, n, s.mean.value);
    s.mean = estimate(s.mean.value, *s.deviation * *s.deviation / static_cast<double>(n), static_cast<int>(n) - 1);
    return s;
}

namespace {

Estimate without_negative_end(Estimate estimate) {
    if (estimate.low && estimate.value >= 0) estimate.low = std::max(*estimate.low, 0.0);
    return estimate;
}

}  // namespace

Sample positive_sample(std::span<const double> values) {
    Sample positive = sample(values);
    positive.mean = without_negative_end(positive.mean);
    return positive;
}

Estimate pooled_mean(const Sample& sample, const Scatter& others) {
    const int own = static_cast<int>(sample.n) - 1;
    const double squares = own * std::pow(sample.deviation.value_or(0), 2) + others.freedom * std::pow(others.deviation, 2);
    const int freedom = own + others.freedom;
    return without_negative_end(estimate(sample.mean.value, squares / freedom / static_cast<double>(sample.n), freedom));
}

std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y) {
    const std::size_t n = x.size();
    if (n < 2 || std::ranges::all_of(x, [&](double value) { return value == x[0]; })) return std::nullopt;
    Line line;
    gsl_fit_linear(x.data(), 1, y.data(), 1, n, &line.intercept, &line.slope, &line.intercept_variance, &line.covariance,
                   &line.slope_variance, &line.residual_sum);
    line.freedom = static_cast<int>(n) - 2;
    if (line.freedom == 0) line.intercept_variance = line.covariance = line.slope_variance = 0;
    const double total = gsl_stats_tss(y.data(), 1, n);
    line.r_squared = total > 0 ? 1 - line.residual_sum / total : 1;
    return line;
}

double rank_correlation(std::span<const double> x, std::span<const double> y) {
    std::vector<double> work(2 * x.size());
    return gsl_stats_spearman(x.data(), 1, y.data(), 1, x.size(), work.data());
}

double median(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    gsl_sort(sorted.data(), 1, sorted.size());
    return gsl_stats_median_from_sorted_data(sorted.data(), 1, sorted.size());
}

}  // namespace graincrack
