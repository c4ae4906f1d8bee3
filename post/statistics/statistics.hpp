// Computes means, straight lines and intervals with GSL.
#pragma once

#include <optional>
#include <span>

namespace graincrack {

/// A value with its 95 % interval, which is empty without degrees of freedom.
struct Estimate {
    double value = 0;
    std::optional<double> low;
    std::optional<double> high;
};

/// Quantile of Student's t for a two-sided 95 % interval. \pre degrees_of_freedom ≥ 1
double student_t_95(int degrees_of_freedom);

/// Returns value ± t · √variance; the value alone without degrees of freedom.
Estimate estimate(double value, double variance, int degrees_of_freedom);

/// Mean and standard deviation (n − 1) of a sample; the interval is that of the mean. Deviation and interval need two values; the
/// mean of no values is NaN.
struct Sample {
    std::size_t n = 0;
    Estimate mean;
    std::optional<double> deviation;
};
Sample sample(std::span<const double> values);
/// A sample of non-negative values, such as strengths; the interval of its mean is not negative either.
Sample positive_sample(std::span<const double> values);

/// Standard deviation of specimens, and its degrees of freedom.
struct Scatter {
    double deviation = 0;
    int freedom = 1;
};
/// The mean of a sample of non-negative values, with an interval from its own scatter and that of others of the same rock.
/// \pre the sample is not empty
Estimate pooled_mean(const Sample& sample, const Scatter& others);

/// Least-squares line y = intercept + slope · x, with variances from the scatter about the line (0 for two points).
struct Line {
    double intercept = 0;
    double slope = 0;
    double intercept_variance = 0;
    double slope_variance = 0;
    double covariance = 0;
    double residual_sum = 0;  ///< sum of squared distances from the line
    double r_squared = 0;     ///< 1 if all y are equal
    int freedom = 0;          ///< points − 2
    [[nodiscard]] Estimate intercept_estimate() const { return estimate(intercept, intercept_variance, freedom); }
    [[nodiscard]] Estimate slope_estimate() const { return estimate(slope, slope_variance, freedom); }
};
/// Fits a line; empty unless there are two different x.
std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y);

/// Spearman's rank correlation, with mean ranks for ties. NaN if all values of one are equal. \pre equally many, two or more
double rank_correlation(std::span<const double> x, std::span<const double> y);

/// The median. \pre values is not empty
double median(std::span<const double> values);

}  // namespace graincrack
