#include "solver/loading/standard_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "share/error.hpp"

namespace graincrack {
namespace {

constexpr double start_transits = 10;      // wave transits the platens take to reach their speed
constexpr double ramp_transits = 40;       // the pressure takes where the rate is automatic: nothing breaks on the way
constexpr double settle_transits = 10;     // that the isotropic stage is held at least
constexpr double give_up_transits = 200;   // and at most
constexpr double servo_transits = 4;       // time constant of the servo
constexpr double settled_pressure = 2e-3;  // wanted axial stress at the end of the isotropic stage, relative
constexpr double settled_balance = 2e-3;   // wanted unbalanced ratio there
constexpr double history_rows = 8000;      // to the strain cap
constexpr std::int64_t min_steps = 20;     // between two rows at a speed that changes: a row costs some two steps
constexpr double max_transits = 0.5;       // and at most: what happens within a transit is to be seen
constexpr double rest_transits = 400;      // that a block may take to come to rest

double smooth_step(double x) {
    const double y = std::clamp(x, 0.0, 1.0);
    return y * y * (3 - 2 * y);
}

/// Axial stress from which on it is a load for the rate: about a fifth of what the test may bear. In compression some fifteen
/// times the tensile strength, in the disc, as load over diameter, π/2 times.
double counting_load(TestKind test, const Rock& rock) {
    switch (test) {
        case TestKind::tension: return 0.2 * rock.tensile_strength;
        case TestKind::brazilian: return 0.3 * rock.tensile_strength;
        default: return 3 * rock.tensile_strength;
    }
}

RateScales rate_scales(TestKind test, const Specimen& s, const Rock& rock, double transit_time) {
    const double stress = counting_load(test, rock);
    const double area = std::accumulate(s.grain_area.begin(), s.grain_area.end(), 0.0);
    return {s.height, transit_time, stress / rock.young_modulus, 0.5 * stress * stress / rock.young_modulus * area};
}

}  // namespace

Loading::Loading(const LoadingRequest& request, const Specimen& specimen, const Rock& rock, PlaneCondition plane)
    : request_(request),
      height_(specimen.height),
      transit_time_(specimen.height / std::sqrt(rock.young_modulus / rock.density)),
      young_modulus_(rock.young_modulus),
      isotropic_compliance_(plane == PlaneCondition::strain
                                ? (1 + rock.poisson_ratio) * (1 - 2 * rock.poisson_ratio) / rock.young_modulus
                                : (1 - rock.poisson_ratio) / rock.young_modulus),
      isotropic_(request.confining_pressure > 0),
      control_(request.rate_tolerance, rate_scales(request.test, specimen, rock, transit_time_), request.rate_share),
      blocks_(request.platen_speed, request.rate_tolerance, rest_transits * transit_time_) {
    const double as_fast_as_the_test = request.confining_pressure / young_modulus_ * height_ / (2 * request.platen_speed);
    ramp_time_ = request.rate == RateKind::automatic ? ramp_transits * transit_time_
                                                     : std::max(start_transits * transit_time_, as_fast_as_the_test);
}

double Loading::target_pressure(double time) const {
    return request_.confining_pressure * (isotropic_ ? smooth_step(time / ramp_time_) : 1.0);
}

double Loading::isotropic_speed(const LoadingFeedback& feedback, double duration) const {
    const double pressure_rate = (target_pressure(feedback.time + duration) - target_pressure(feedback.time)) / duration;
    const double lag = target_pressure(feedback.time) - mean_compression_;
    const double servo_time = std::max(servo_transits * transit_time_, 4 * duration);
    return 0.5 * height_ * (isotropic_compliance_ * pressure_rate + lag / (young_modulus_ * servo_time));
}

double Loading::axial_speed(const LoadingFeedback& feedback, double duration) {
    const double sense = request_.test == TestKind::tension ? -1 : 1;
    switch (request_.rate) {
        case RateKind::fixed: {
            const double begun = (feedback.time + duration - start_time_) / (start_transits * transit_time_);
            return start_speed_ + (sense * request_.platen_speed - start_speed_) * smooth_step(begun);
        }
        case RateKind::automatic: {
            RateMeasures measures = feedback.rate;
            measures.strain = axial_strain_;
            const double speed = control_.next(measures, duration);
            axial_strain_ += duration * (sense * speed_ + speed) / height_;
            return sense * speed;
        }
        case RateKind::blocks: return sense * blocks_.next(feedback.unbalanced_ratio, duration);
    }
    return 0;
}

std::int64_t Loading::interval_steps(double time_step) const {
    const double travel = request_.max_strain * height_ / 2 / history_rows;
    if (request_.rate == RateKind::fixed) {
        return std::max<std::int64_t>(10, static_cast<std::int64_t>(travel / request_.platen_speed / time_step));
    }
    if (request_.rate == RateKind::blocks && !isotropic_) {
        return std::max<std::int64_t>(1, request_.block_steps / parts_of_block);
    }
    const double most = max_transits * transit_time_ / time_step;
    const double wanted = speed_ == 0 ? most : std::min(most, travel / std::abs(speed_) / time_step);
    return std::max(min_steps, static_cast<std::int64_t>(wanted));
}

double Loading::mean_speed(double time) const {
    return time > start_time_ ? 0.5 * height_ * axial_strain_ / (time - start_time_) : 0;
}

double Loading::slowest_speed(double strain) const {
    switch (request_.rate) {
        case RateKind::fixed: return request_.platen_speed;
        case RateKind::automatic: return control_.min_speed(strain, request_.rate_tolerance);
        case RateKind::blocks: return request_.platen_speed * moving_share_of_block;
    }
    return request_.platen_speed;
}

LoadingLength Loading::longest(double time_step) const {
    const double travel = request_.max_strain * height_ / 2;
    double time = 0;
    constexpr int parts = 1000;
    for (int i = 0; i < parts; ++i) {
        time += travel / parts / slowest_speed(request_.max_strain * (i + 0.5) / parts);
    }
    const double steps = time / time_step;
    const double rows = request_.rate == RateKind::automatic ? history_rows + time / (max_transits * transit_time_)
                                                             : steps / static_cast<double>(interval_steps(time_step));
    return {static_cast<std::int64_t>(steps), static_cast<std::size_t>(rows)};
}

IntervalLoading Loading::next(const LoadingFeedback& feedback, double duration) {
    // The servo answers to the stress of the last wave transit: the platens' springs ring too fast for it.
    mean_compression_ += std::min(1.0, duration / transit_time_) * (feedback.axial_compression - mean_compression_);
    if (isotropic_ && feedback.time > ramp_time_ + settle_transits * transit_time_) {
        const double error = std::abs(mean_compression_ / request_.confining_pressure - 1);
        if (error < settled_pressure && feedback.unbalanced_ratio < settled_balance) {
            isotropic_ = false;
            isotropic_end_time_ = start_time_ = feedback.time;
            start_speed_ = speed_;
        } else if (feedback.time > ramp_time_ + give_up_transits * transit_time_) {
            throw NumericalError(
                fmt::format("the isotropic stage does not settle: axial stress {:.2f} % off the confining pressure; "
                            "use more --damping or a slower --rate",
                            100 * error));
        }
    }
    const double old_speed = speed_;
    const double end = feedback.time + duration;
    speed_ = isotropic_ ? isotropic_speed(feedback, duration) : axial_speed(feedback, duration);
    IntervalLoading batch;
    batch.velocity_begin = {old_speed, -old_speed};
    batch.velocity_end = {speed_, -speed_};
    batch.pressure_begin = target_pressure(feedback.time);
    batch.pressure_end = target_pressure(end);
    return batch;
}

}  // namespace graincrack
