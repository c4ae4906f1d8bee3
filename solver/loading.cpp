#include "solver/loading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "share/error.hpp"

namespace graincrack {
namespace {

constexpr double start_transits = 10;      // wave transits the platens take to reach their speed
constexpr double settle_transits = 10;     // that the isotropic stage is held at least
constexpr double give_up_transits = 200;   // and at most
constexpr double servo_transits = 4;       // time constant of the servo
constexpr double settled_pressure = 2e-3;  // wanted axial stress at the end of the isotropic stage, relative
constexpr double settled_balance = 2e-3;   // wanted unbalanced ratio there

double smooth_step(double x) {
    const double y = std::clamp(x, 0.0, 1.0);
    return y * y * (3 - 2 * y);
}

}  // namespace

Boundary make_test_boundary(const Assemblage& a, const Specimen& s, const LoadingRequest& request,
                            const ContactParameters& contact) {
    const bool pulls = request.test == TestKind::tension;
    std::array<Platen, 2> platens;
    for (std::size_t p = 0; p < 2; ++p) {
        platens[p].side = p == top_platen ? 1 : -1;
        platens[p].position = platens[p].side * s.height / 2;
        platens[p].normal_stiffness = contact.normal_stiffness;
        platens[p].shear_stiffness = pulls ? 0 : contact.shear_stiffness;
        platens[p].tan_friction = std::tan(request.platen_friction);
        platens[p].bonded = pulls;
    }
    // A platen can be met by whatever its own approach and a loose grain's turn can bring to it.
    const double reach = 2 * s.statistics.mean_edge + request.max_strain * s.height;
    std::vector<std::uint8_t> membrane;
    if (request.confining_pressure > 0) {
        membrane = {static_cast<std::uint8_t>(BoundaryPart::left), static_cast<std::uint8_t>(BoundaryPart::right)};
    }
    return make_boundary(a, s, platens, reach, membrane);
}

Loading::Loading(const LoadingRequest& request, const Specimen& specimen, const Rock& rock, PlaneCondition plane)
    : request_(request),
      height_(specimen.height),
      transit_time_(specimen.height / std::sqrt(rock.young_modulus / rock.density)),
      young_modulus_(rock.young_modulus),
      isotropic_compliance_(plane == PlaneCondition::strain
                                ? (1 + rock.poisson_ratio) * (1 - 2 * rock.poisson_ratio) / rock.young_modulus
                                : (1 - rock.poisson_ratio) / rock.young_modulus),
      isotropic_(request.confining_pressure > 0) {
    const double as_fast_as_the_test = request.confining_pressure / young_modulus_ * height_ / (2 * request.platen_speed);
    ramp_time_ = std::max(start_transits * transit_time_, as_fast_as_the_test);
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

BatchLoading Loading::next(const LoadingFeedback& feedback, double duration) {
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
    if (isotropic_) {
        speed_ = isotropic_speed(feedback, duration);
    } else {
        const double full = request_.test == TestKind::tension ? -request_.platen_speed : request_.platen_speed;
        speed_ = start_speed_ + (full - start_speed_) * smooth_step((end - start_time_) / (start_transits * transit_time_));
    }
    BatchLoading batch;
    batch.velocity_begin = {old_speed, -old_speed};
    batch.velocity_end = {speed_, -speed_};
    batch.pressure_begin = target_pressure(feedback.time);
    batch.pressure_end = target_pressure(end);
    return batch;
}

}  // namespace graincrack
