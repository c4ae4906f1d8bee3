#include "solver/step/load_clock.hpp"

#include <cstddef>

namespace graincrack {

LoadingClock::LoadingClock(const IntervalLoading& interval, std::int64_t n_steps, double time_step, const State& s)
    : interval_(interval),
      n_steps_(n_steps),
      time_step_(time_step),
      origin_time_(s.origin_time),
      steps_since_origin_(s.step - s.origin_step),
      now_(s.loading) {
    now_.amplitudes.resize(interval.amplitudes == nullptr ? 0 : interval.amplitudes->size());
    prepare();
}

void LoadingClock::tick() {
    ++k_;
    for (std::size_t p = 0; p < 2; ++p) {
        now_.platen_displacement[p] += now_.increment_after[p];
        now_.increment_before[p] = now_.increment_after[p];
    }
    prepare();
}

void LoadingClock::prepare() {
    const double fraction = (static_cast<double>(k_) + 0.5) / static_cast<double>(n_steps_);
    for (std::size_t p = 0; p < 2; ++p) {
        const double velocity =
            interval_.velocity_begin[p] + fraction * (interval_.velocity_end[p] - interval_.velocity_begin[p]);
        now_.increment_after[p] = time_step_ * velocity;
    }
    const double time = origin_time_ + static_cast<double>(steps_since_origin_ + k_) * time_step_;
    for (std::size_t i = 0; i < now_.amplitudes.size(); ++i) {
        const Amplitude& amplitude = (*interval_.amplitudes)[i];
        now_.amplitudes[i] = amplitude.at(amplitude.of_velocity ? time + 0.5 * time_step_ : time);
    }
    if (interval_.temperature != no_amplitude) now_.temperature = now_.amplitudes[interval_.temperature];
}

}  // namespace graincrack
