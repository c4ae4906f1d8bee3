#include "post/measure/mean_over_strain.hpp"

#include <algorithm>

namespace graincrack {

MeanOverStrain::MeanOverStrain(std::span<const double> strain, std::span<const double> value) {
    for (std::size_t row = 0; row < strain.size(); ++row) {
        if (!strain_.empty() && !(strain[row] > strain_.back())) continue;
        const double area = strain_.empty() ? 0.0 : 0.5 * (value[row] + value_.back()) * (strain[row] - strain_.back());
        integral_.push_back(integral_.empty() ? 0.0 : integral_.back() + area);
        strain_.push_back(strain[row]);
        value_.push_back(value[row]);
    }
}

MeanOverStrain::Place MeanOverStrain::at(double strain) const {
    const auto above = std::upper_bound(strain_.begin(), strain_.end(), strain);
    if (above == strain_.begin()) return {value_.front(), 0};
    if (above == strain_.end()) return {value_.back(), integral_.back()};
    const auto end = static_cast<std::size_t>(above - strain_.begin());
    const double step = strain - strain_[end - 1];
    const double slope = (value_[end] - value_[end - 1]) / (strain_[end] - strain_[end - 1]);
    const double value = value_[end - 1] + slope * step;
    return {value, integral_[end - 1] + 0.5 * (value_[end - 1] + value) * step};
}

double MeanOverStrain::mean(double from, double to) const {
    const double low = std::max(from, first_strain());
    const double high = std::min(to, last_strain());
    if (!(high > low)) return at(low).value;
    return (at(high).integral - at(low).integral) / (high - low);
}

double MeanOverStrain::moving_mean(double strain, double width) const {
    const double half = std::max(0.0, std::min({0.5 * width, strain - first_strain(), last_strain() - strain}));
    return mean(strain - half, strain + half);
}

std::vector<double> moving_mean(std::span<const double> strain, std::span<const double> value, double width) {
    const MeanOverStrain curve(strain, value);
    std::vector<double> smooth(strain.size());
    std::transform(strain.begin(), strain.end(), smooth.begin(), [&](double at) { return curve.moving_mean(at, width); });
    return smooth;
}

}  // namespace graincrack
