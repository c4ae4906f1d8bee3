#include "solver/loading/rate_control.hpp"

#include <fmt/format.h>

#include <cmath>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

// The numbers of this list whose measurement is not given were chosen by trial and not varied since.
constexpr double max_damping_load = 2e-3;  // friction multiplies it: a strength is off by up to five times that, 1 %
constexpr double max_inertia = 0.1;        // largest limit of the first two measures: kinetic over stored energy is 1e-3
// Largest relative rise of the strain in a transit near failure. Fitted: first peaks at 8 MPa of six specimens were 1.0 ± 0.8 %
// too high against a quarter of the speed, with 0.06 throughout 4.3 ± 1.0 % (share/studies/equilibrium).
constexpr double damage_rise = 0.015;
// The same while failure involves little of the section. Measured: first peaks change by +0.1 ± 0.3 %, steps by −15 to −35 %.
constexpr double elastic_rise = 0.06;
constexpr double first_damage = 0.1;   // from this `near_failure` on `damage_rise` holds
constexpr double follow_transits = 4;  // transits in which the speed changes at most e-fold
constexpr double slowest = 0.05;  // lowest speed, over the one that the tolerance allows in an elastic bar (0.25 and 0.5 before)
// Behind a peak the memory of a failing section fades: it decays e-fold in so many transits while the load is below this fraction
// of the highest. Chosen; not varied since.
constexpr double memory_transits = 20;
constexpr double behind_peak = 0.95;
constexpr double smoothing_transits = 1;  // transits over which measures are averaged
constexpr double stopping_transits = 2;   // time constant with which a change of temperature approaches its end, transits

/// Limit of the first two measures at a value of `near_failure`.
double relaxed(double tolerance, double near_failure) {
    return std::clamp(tolerance / std::max(near_failure, 1e-9), tolerance, std::max(tolerance, max_inertia));
}
/// Largest relative rise of the strain, or of a change of temperature, in a transit.
double fastest_rise(double near_failure) {
    return std::clamp(damage_rise * first_damage / std::max(near_failure, 1e-9), damage_rise, elastic_rise);
}
/// The speed that follows `speed`. \param worst largest ratio of a measure to its limit \param follow e-folds allowed
double followed(double speed, double worst, double follow) {
    const double change = -std::log(std::max(worst, 1e-12));  // e-folds of speed
    return speed * std::exp(std::clamp(change * follow, -follow, follow));
}

}  // namespace

double RateControl::allowed(double near_failure) const { return fraction_ * relaxed(tolerance_, near_failure); }

double RateControl::max_speed(double strain, double near_failure) const {
    const double rise = fastest_rise(near_failure);
    return fraction_ * 0.5 * scales_.height / scales_.transit_time * rise * std::max(strain, scales_.min_strain);
}

double RateControl::min_speed(double strain, double allowed) const {
    const double wave_speed = scales_.height / scales_.transit_time;
    return std::min(slowest * allowed * 0.5 * wave_speed * std::max(strain, scales_.min_strain), max_speed(strain, 1));
}

double RateControl::next(const Feedback& now, double strain, double duration) {
    const double fraction = std::min(1.0, duration / (smoothing_transits * scales_.transit_time));
    // The energy ½ m v(n−½)·v(n+½) of nodes that reverse within the step is negative.
    const double kinetic = std::max(now.kinetic_energy, 0.0);
    const double inertia = std::sqrt(12 * kinetic / std::max(now.stored_energy, scales_.min_energy));
    inertia_ += fraction * (inertia - inertia_);
    unbalanced_ratio_ += fraction * (now.unbalanced_ratio - unbalanced_ratio_);
    force_difference_ += fraction * (now.force_difference - force_difference_);
    const double load = std::abs(now.axial_compression);
    highest_load_ = std::max(highest_load_, load);
    if (load < behind_peak * highest_load_) near_failure_ *= std::exp(-duration / (memory_transits * scales_.transit_time));
    near_failure_ = std::max(near_failure_, now.near_failure);
    const double limit = allowed(near_failure_);
    const double most_damping = fraction_ * max_damping_load * fastest_rise(near_failure_) / damage_rise;
    const bool is_elastic_bar = near_failure_ < first_damage && !scales_.bends;
    const double most_difference = is_elastic_bar ? limit : fraction_ * tolerance_;
    const double worst = std::max(
        {inertia_ / limit, unbalanced_ratio_ / limit, force_difference_ / most_difference, now.damping_load / most_damping});
    speed_ = followed(speed_, worst, duration / (follow_transits * scales_.transit_time));
    speed_ = std::min(std::max(speed_, min_speed(strain, limit)), max_speed(strain, near_failure_));
    return speed_;
}

double HeatingControl::max_rate(double change, double near_failure) const {
    const double rise = fraction_ * std::min(relaxed(tolerance_, near_failure), fastest_rise(near_failure));
    return rise * std::max(change, scales_.least_change) / scales_.transit_time;
}

double HeatingControl::min_rate(double change) const {
    return slowest * fraction_ * tolerance_ * std::max(change, scales_.least_change) / scales_.transit_time;
}

double HeatingControl::usual_time(double change) const {
    const double folds = change / scales_.least_change;
    return scales_.transit_time / (fraction_ * tolerance_) * (std::min(folds, 1.0) + std::log(std::max(folds, 1.0)));
}

double HeatingControl::next(const Feedback& now, double change, double left, double duration) {
    change = std::max(change, scales_.change(now.stored_energy));
    const double transits = duration / scales_.transit_time;
    unbalanced_ratio_ += std::min(1.0, transits / smoothing_transits) * (scales_.loaded(now) - unbalanced_ratio_);
    near_failure_ = std::max(near_failure_, now.near_failure);
    const double fastest = max_rate(change, near_failure_);
    const double worst = std::max(rate_ / fastest, unbalanced_ratio_ / (fraction_ * relaxed(tolerance_, near_failure_)));
    rate_ = std::clamp(followed(rate_, worst, transits / follow_transits), min_rate(change), fastest);
    return std::min(rate_, std::max(left / (stopping_transits * scales_.transit_time), min_rate(0)));
}

double BlockControl::next(double unbalanced_ratio, double duration) {
    if (part_ == parts_of_block && unbalanced_ratio < tolerance_) {
        part_ = 0;
        stands_ = 0;
    }
    if (part_ < parts_of_block) {
        ++part_;
        return part_ < parts_of_block ? speed_ : 0;
    }
    stands_ += duration;
    if (stands_ > give_up_) {
        throw NumericalError(fmt::format(
            "no equilibrium between two blocks: after {:.3g} s the unbalanced ratio is {:.2e}, not below {:.2e}; use more "
            "--damping, a larger --rate-tolerance or --rate auto",
            stands_, unbalanced_ratio, tolerance_));
    }
    return 0;
}

}  // namespace graincrack
