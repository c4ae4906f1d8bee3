#include "mesher/cells/cell_areas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace graincrack::mesher {

namespace {

constexpr double cut_off = 3;               ///< standard deviations
constexpr double smallest_diameter = 0.25;  ///< smallest diameter of a normal distribution, over its middle
constexpr double widest_scatter = 4;        ///< largest scatter of diameters that is tried

double normal_probability(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// The inverse of `normal_probability` with an error of 1e-9 (rational approximation of P. J. Acklam).
double normal_quantile(double q) {
    const auto tail = [](double p) {
        const double r = std::sqrt(-2 * std::log(p));
        return (((((-7.784894002430293e-03 * r - 3.223964580411365e-01) * r - 2.400758277161838) * r - 2.549732539343734) * r +
                 4.374664141464968) *
                    r +
                2.938163982698783) /
               ((((7.784695709041462e-03 * r + 3.224671290700398e-01) * r + 2.445134137142996) * r + 3.754408661907416) * r + 1);
    };
    constexpr double tails = 0.02425;
    if (q < tails) return tail(q);
    if (q > 1 - tails) return -tail(1 - q);
    const double x = q - 0.5;
    const double r = x * x;
    return (((((-3.969683028665376e+01 * r + 2.209460984245205e+02) * r - 2.759285104469687e+02) * r + 1.383577518672690e+02) *
                 r -
             3.066479806614716e+01) *
                r +
            2.506628277459239) *
           x /
           (((((-5.447609879822406e+01 * r + 1.615858368580409e+02) * r - 1.556989798598866e+02) * r + 6.680131188771972e+01) *
                 r -
             1.328068155288572e+01) *
                r +
            1);
}

/// Standard deviation over the mean.
double variation(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return std::sqrt(squares / n) / mean;
}

/// Relative diameters at quantiles of a distribution with the middle 1. \param scatter standard deviation of the diameters if
/// they are normal, otherwise of their logarithms
std::vector<double> diameters_at(const std::vector<double>& quantiles, double scatter, SizeDistribution distribution) {
    const bool is_normal = distribution == SizeDistribution::normal;
    const double lowest = is_normal ? std::max(-cut_off, (smallest_diameter - 1) / scatter) : -cut_off;
    const double below = normal_probability(lowest);
    const double above = normal_probability(cut_off);
    std::vector<double> diameters;
    diameters.reserve(quantiles.size());
    for (const double q : quantiles) {
        const double z = scatter * normal_quantile(below + q * (above - below));
        diameters.push_back(is_normal ? 1 + z : std::exp(z));
    }
    return diameters;
}

double square_of(double value) { return value * value; }

}  // namespace

std::vector<double> requested_areas(std::size_t n, double total, double spread, SizeDistribution distribution,
                                    RandomNumbers& random) {
    std::vector<double> diameters(n, 1.0);
    if (spread > 0 && n > 1) {
        // There is one quantile in each n-th of the distribution, in random order.
        std::vector<double> quantiles(n);
        for (std::size_t i = 0; i < n; ++i) quantiles[i] = (static_cast<double>(i) + random.uniform()) / static_cast<double>(n);
        for (std::size_t i = n; i > 1; --i) std::swap(quantiles[i - 1], quantiles[random.below(i)]);
        double low = 0, high = widest_scatter;
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (low + high);
            diameters = diameters_at(quantiles, middle, distribution);
            (variation(diameters) < spread ? low : high) = middle;
        }
    }
    std::vector<double> areas;
    areas.reserve(n);
    for (const double diameter : diameters) areas.push_back(diameter * diameter);
    const double scale = total / std::accumulate(areas.begin(), areas.end(), 0.0);
    for (double& area : areas) area *= scale;
    return areas;
}

double diameter_variation(const std::vector<double>& areas) {
    std::vector<double> diameters;
    diameters.reserve(areas.size());
    for (const double area : areas) diameters.push_back(std::sqrt(area));
    return variation(diameters);
}

GradedAreas::GradedAreas(std::vector<double> drawn, const SizeField& size, std::vector<std::size_t> part_of_cell)
    : drawn_(std::move(drawn)), size_(size.varies() ? &size : nullptr), part_of_cell_(std::move(part_of_cell)) {
    if (part_of_cell_.empty()) part_of_cell_.assign(drawn_.size(), 0);
    const std::size_t n_parts = 1 + *std::max_element(part_of_cell_.begin(), part_of_cell_.end());
    part_areas_.assign(n_parts, 0);
    for (std::size_t cell = 0; cell < drawn_.size(); ++cell) part_areas_[part_of_cell_[cell]] += drawn_[cell];
}

std::vector<double> GradedAreas::at(const std::vector<Point>& places) const {
    if (!are_graded()) return drawn_;
    std::vector<double> areas = drawn_;
    std::vector<double> sums(part_areas_.size(), 0);
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
        areas[cell] *= square_of(size_->graded(places[cell]));
        sums[part_of_cell_[cell]] += areas[cell];
    }
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
        areas[cell] *= part_areas_[part_of_cell_[cell]] / sums[part_of_cell_[cell]];
    }
    return areas;
}

}  // namespace graincrack::mesher
