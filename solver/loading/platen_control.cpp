#include "solver/loading/platen_control.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "share/file/peak.hpp"
#include "share/file/specimen_measures.hpp"

namespace graincrack {
namespace {

// All numbers of this list were chosen by trial and not varied since.
constexpr double servo_transits = 4;            // time constant of the servo, transits
constexpr double rows_to_max_strain = 8000;     // rows up to the strain limit
constexpr std::int64_t min_steps_per_row = 20;  // fewest steps between two rows; a row costs about two steps
constexpr double max_transits = 0.5;            // most transits between two rows, so that rows resolve events within a transit
constexpr double rest_transits = 400;           // transits in which a block has to come to rest
// Axial stress, over the tensile strength, from which on the rules of the rate apply. It is about a fifth of the
// strength: a disc bears π/2 times the tensile strength as load over diameter, a rectangle about fifteen times it.
constexpr double tension_load = 0.2;
constexpr double bending_load = 0.3;  // of the nominal bending stress
constexpr double disc_load = 0.3;
constexpr double compression_load = 3.0;

}  // namespace

PlatenControl::PlatenControl(const Specimen& specimen, const Rock& rock, const ProgramPlatens& platens)
    : height_(specimen.height),
      area_(std::accumulate(specimen.grain_area.begin(), specimen.grain_area.end(), 0.0)),
      transit_time_(bar_transit_time(specimen, rock)),
      has_end_faces_(has_end_faces(specimen)),
      is_bonded_(platens.bonded),
      span_(platens.span()),
      rock_(rock),
      max_strain_(platens.max_strain),
      rate_(default_rate_tolerance, {}),
      blocks_(0, default_rest_tolerance, 0) {}

double PlatenControl::least_load(bool apart) const {
    return apart ? tension_load : has_end_faces_ ? compression_load : disc_load;
}

double PlatenControl::load_stress() const { return span_ > 0 ? 0 : least_load(is_bonded_) * rock_.tensile_strength; }

double PlatenControl::settling_stress() const { return settling_load / compression_load * load_stress(); }

RateScales PlatenControl::rate_scales(bool apart) const {
    if (span_ > 0) {
        // A beam with this stress in its lowest fibre deflects by stress/E S²/(6 H) and stores the energy of a bar under a third
        // of the stress. Waves along the beam, not across it, determine how fast it responds.
        const double stress = bending_load * rock_.tensile_strength;
        const double slenderness = span_ / height_;
        return {height_, transit_time_ * slenderness, stress / rock_.young_modulus * slenderness * slenderness / 6,
                0.5 * stress * stress / 9 / rock_.young_modulus * span_ * height_, true};
    }
    const double stress = least_load(apart) * rock_.tensile_strength;
    return {height_, transit_time_, stress / rock_.young_modulus, 0.5 * stress * stress / rock_.young_modulus * area_};
}

void PlatenControl::set(const PlatenMotion& motion, double time) {
    const double pressure = as<PressureServo>() != nullptr ? amplitude_.at(time) : mean_compression_;
    motion_ = motion;
    amplitude_ = {{}, time};
    strain_ = 0;
    if (const auto* const function = as<TimeFunction>()) {
        amplitude_ = {starting_from(*function, speed_), time};
        speed_ = amplitude_.at(time);
    } else if (const auto* const servo = as<PressureServo>()) {
        amplitude_ = {starting_from(servo->pressure, pressure), time};
    } else if (const auto* const rate = as<AutomaticRate>()) {
        rate_ = RateControl(rate->tolerance, rate_scales(rate->apart), rate->share);
    } else if (const auto* const blocks = as<LoadingBlocks>()) {
        blocks_ = BlockControl(blocks->speed, blocks->rest, rest_transits * transit_time_);
    }
}

void PlatenControl::take_over(double speed, double mean_compression) {
    TimeFunction constant;
    constant.value = speed;
    motion_ = constant;
    amplitude_ = {constant, 0};
    speed_ = speed;
    mean_compression_ = mean_compression;
}

double PlatenControl::servo_speed(double time, double duration) const {
    const double rate = (amplitude_.at(time + duration) - amplitude_.at(time)) / duration;
    const double lag = amplitude_.at(time) - mean_compression_;
    const double servo_time = std::max(servo_transits * transit_time_, 4 * duration);
    return 0.5 * height_ / rock_.young_modulus * (rate + lag / servo_time);
}

PlatenSpeeds PlatenControl::next(const Feedback& feedback, double duration) {
    // The servo responds to the mean stress of the last wave transit, as the platens' springs oscillate too fast for it.
    mean_compression_ += std::min(1.0, duration / transit_time_) * (feedback.axial_compression - mean_compression_);
    const double begin = speed_;
    double sense = 1;
    if (as<TimeFunction>() != nullptr) {
        speed_ = amplitude_.at(feedback.time + duration);
    } else if (as<PressureServo>() != nullptr) {
        speed_ = servo_speed(feedback.time, duration);
    } else if (const auto* const rate = as<AutomaticRate>()) {
        sense = rate->apart ? -1 : 1;
        speed_ = sense * rate_.next(feedback, strain_, duration);
    } else {
        speed_ = blocks_.next(feedback.unbalanced_ratio, duration);
    }
    strain_ += duration * (sense * begin + sense * speed_) / height_;
    return {begin, speed_};
}

bool PlatenControl::paces_rows() const { return as<AutomaticRate>() != nullptr || as<LoadingBlocks>() != nullptr; }

std::int64_t PlatenControl::interval_steps(double time_step) const {
    const double travel = max_strain_ * height_ / 2 / rows_to_max_strain;
    if (const auto* const blocks = as<LoadingBlocks>()) return std::max<std::int64_t>(1, blocks->steps / parts_of_block);
    const double at_most = max_transits * transit_time_ / time_step;
    if (as<TimeFunction>() != nullptr) {
        const double speed = final_speed();
        return std::max<std::int64_t>(min_steps_per_row / 2,
                                      static_cast<std::int64_t>(speed == 0 ? at_most : travel / speed / time_step));
    }
    const double requested = speed_ == 0 ? at_most : std::min(at_most, travel / std::abs(speed_) / time_step);
    return std::max(min_steps_per_row, static_cast<std::int64_t>(requested));
}

double PlatenControl::mean_speed(double time) const {
    return time > amplitude_.start ? 0.5 * height_ * strain_ / (time - amplitude_.start) : 0;
}

double PlatenControl::function_end() const {
    const bool is_function = as<TimeFunction>() != nullptr || as<PressureServo>() != nullptr;
    return is_function ? amplitude_.start + amplitude_.function.end() : 0;
}

double PlatenControl::pressure_error(double time) const {
    const double aim = amplitude_.at(time);
    return as<PressureServo>() != nullptr && aim != 0 ? mean_compression_ / aim - 1 : 0;
}

double PlatenControl::final_speed() const {
    const double end = amplitude_.function.end();
    return std::abs(std::isfinite(end) ? amplitude_.function(end) : amplitude_.function.value);
}

double PlatenControl::slowest_speed(double strain) const {
    if (const auto* const rate = as<AutomaticRate>()) return rate_.min_speed(strain, rate->tolerance);
    if (const auto* const blocks = as<LoadingBlocks>()) return std::abs(blocks->speed) * moving_fraction_of_block;
    return final_speed();
}

double PlatenControl::longest_time() const {
    const double travel = max_strain_ * height_ / 2;
    double time = 0;
    constexpr int parts = 1000;
    for (int i = 0; i < parts; ++i) time += travel / parts / slowest_speed(max_strain_ * (i + 0.5) / parts);
    return time + (std::isfinite(function_end()) ? function_end() : 0);  // the speed is lower before its function ends
}

}  // namespace graincrack
