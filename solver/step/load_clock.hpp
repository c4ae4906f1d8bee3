// Platens and amplitudes at each step of an interval of loading.
#pragma once

#include <cstdint>

#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

/// Each thread has its own; all do the same arithmetic.
class LoadingClock {
public:
    LoadingClock(const IntervalLoading& interval, std::int64_t n_steps, double time_step, const State& state);
    [[nodiscard]] const StepLoading& now() const { return now_; }
    void tick();

private:
    void prepare();
    IntervalLoading interval_;
    std::int64_t n_steps_;
    double time_step_;
    double origin_time_;
    std::int64_t steps_since_origin_;
    std::int64_t k_ = 0;
    StepLoading now_;
};

}  // namespace graincrack
