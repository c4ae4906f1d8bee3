#include "post/calibrate/search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace graincrack::calibrate {

void Levels::add(double x, std::vector<double> results) { results_[x] = std::move(results); }

double Levels::mean_at(double x) const {
    const std::vector<double>& results = results_.at(x);
    return std::accumulate(results.begin(), results.end(), 0.0) / static_cast<double>(results.size());
}

std::vector<double> Levels::levels() const {
    std::vector<double> out;
    for (const auto& [x, results] : results_) out.push_back(x);
    return out;
}

std::optional<Estimate> Levels::slope() const {
    if (results_.size() < 2) return std::nullopt;
    const auto n_levels = static_cast<double>(results_.size());
    const std::size_t specimens = results_.begin()->second.size();
    double mean_x = 0;
    for (const auto& [x, results] : results_) mean_x += x / n_levels;
    double sxx = 0;
    double sxy = 0;
    double syy = 0;
    for (std::size_t s = 0; s < specimens; ++s) {
        double mean_y = 0;
        for (const auto& [x, results] : results_) mean_y += std::log(results[s]) / n_levels;
        for (const auto& [x, results] : results_) {
            const double y = std::log(results[s]) - mean_y;
            sxx += (x - mean_x) * (x - mean_x);
            sxy += (x - mean_x) * y;
            syy += y * y;
        }
    }
    const double slope = sxy / sxx;
    const int freedom = static_cast<int>(specimens * (results_.size() - 1)) - 1;
    const double residual = std::max(syy - slope * sxy, 0.0);
    return estimate(slope, freedom > 0 ? residual / freedom / sxx : 0, freedom);
}

double Levels::nearest(double wanted) const {
    const std::vector<double> xs = levels();
    return *std::min_element(xs.begin(), xs.end(), [&](double a, double b) {
        return std::abs(std::log(mean_at(a) / wanted)) < std::abs(std::log(mean_at(b) / wanted));
    });
}

double Levels::crossing(double wanted, double slope) const {
    std::optional<std::pair<double, double>> below;  // x and ln(mean/wanted), nearest to 0
    std::optional<std::pair<double, double>> above;
    for (const auto& [x, results] : results_) {
        const double off = std::log(mean_at(x) / wanted);
        if (off <= 0 && (!below || off > below->second)) below = {x, off};
        if (off > 0 && (!above || off < above->second)) above = {x, off};
    }
    // A bracket counts if the mean rises across it as the trend does; otherwise scatter has turned it over.
    if (below && above && (above->first - below->first) * slope > 0) {
        return below->first - below->second * (above->first - below->first) / (above->second - below->second);
    }
    const double x = nearest(wanted);
    return x - std::log(mean_at(x) / wanted) / slope;
}

}  // namespace graincrack::calibrate
