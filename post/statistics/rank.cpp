#include "post/statistics/rank.hpp"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include <vector>

namespace graincrack {

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
