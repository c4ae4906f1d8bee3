#include "solver/model/amplitude.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace graincrack {
namespace {

using std::numbers::pi;

/// The half-width at which the wavelet has died down to 1e-14 of its peak: a = 36, e^−a (2 a − 1) < 2e-14.
constexpr double wavelet_reach = 6;

double interpolated(const std::vector<double>& times, const std::vector<double>& values, double t) {
    const auto after = std::upper_bound(times.begin(), times.end(), t);
    if (after == times.begin()) return values.front();
    if (after == times.end()) return values.back();
    const auto i = static_cast<std::size_t>(after - times.begin());
    return values[i - 1] + (values[i] - values[i - 1]) * (t - times[i - 1]) / (times[i] - times[i - 1]);
}

}  // namespace

double TimeFunction::operator()(double t) const {
    switch (kind) {
        case Kind::constant: return value;
        case Kind::keep: return from;
        case Kind::ramp: {
            const double x = std::clamp(t / duration, 0.0, 1.0);
            return from + (value - from) * (x * x * (3 - 2 * x));
        }
        case Kind::table: return interpolated(times, values, t);
        case Kind::sine:
            return t < 0 || (duration > 0 && t > duration) ? from : from + value * std::sin(2 * pi * frequency * t + phase);
        case Kind::ricker: {
            const double x = pi * frequency * (t - peak_time);
            return from + value * (1 - 2 * x * x) * std::exp(-x * x);
        }
        case Kind::rate: return std::abs(value - from) <= rate * t ? value : from + std::copysign(rate * t, value - from);
        case Kind::pulse: {
            const double s = t < 0 || t > duration ? 0.0 : std::sin(pi * t / duration);
            return from + value * (s * s);
        }
    }
    return value;
}

double TimeFunction::end() const {
    switch (kind) {
        case Kind::constant:
        case Kind::keep: return 0;
        case Kind::ramp:
        case Kind::pulse: return duration;
        case Kind::table: return times.back();
        case Kind::rate: return value == from ? 0 : std::abs(value - from) / rate;
        case Kind::sine: return duration > 0 ? duration : std::numeric_limits<double>::infinity();
        case Kind::ricker: return peak_time + wavelet_reach / (pi * frequency);
    }
    return 0;
}

TimeFunction starting_from(TimeFunction function, double present) {
    const bool keeps_free = function.kind == TimeFunction::Kind::keep && std::isnan(present);
    function.from = std::isnan(present) && !keeps_free ? 0 : present;
    return function;
}

}  // namespace graincrack
