#include "solver/loading/stage_control.hpp"

#include <algorithm>
#include <cmath>

namespace graincrack {
namespace {

constexpr double servo_transits = 4;  // time constant of the servo
constexpr int rest_rows = 5;          // in succession that must be at rest: one may be so by chance

double last(const StageFeedback& f, HistoryColumn column) { return f.history[column].back(); }

/// Distance of a condition from being reached, with its side.
double offset(const Condition& c, const StageFeedback& f) {
    return (c.probe.empty() ? f.history.columns[c.column].back() : f.probe(c.probe, c.column)) - c.value;
}

/// The function with its start at what is there now.
TimeFunction from_present(TimeFunction function, double present) {
    const bool keeps_free = function.kind == TimeFunction::Kind::keep && std::isnan(present);
    function.from = std::isnan(present) && !keeps_free ? 0 : present;
    return function;
}

}  // namespace

StageController::StageController(const Program& program, const Specimen& specimen, const Rock& rock)
    : program_(program),
      numbers_(number_amplitudes(program)),
      height_(specimen.height),
      transit_time_(specimen.height / std::sqrt(rock.young_modulus / rock.density)),
      young_modulus_(rock.young_modulus) {
    for (const Control& control : program.controls) {
        for (std::size_t i = 0; i < n_actions; ++i) {
            if (!control.is_set[i]) {
                continue;
            }
            const bool prescribed = is_velocity(static_cast<Action>(i));
            TimeFunction free;
            free.value = prescribed ? NAN : 0;
            amplitudes_.push_back({free, 0, prescribed});
        }
    }
}

void StageController::resume(const StageControllerState& state) {
    for (std::size_t c = 0; c < program_.controls.size(); ++c) {
        for (std::size_t i = 0; i < n_actions; ++i) {
            const std::string name = program_.controls[c].name + "." + std::string(name_of(static_cast<Action>(i)));
            const auto found = std::find(state.names.begin(), state.names.end(), name);
            if (numbers_[c][i] != no_amplitude && found != state.names.end()) {
                amplitudes_[numbers_[c][i]].function.value = state.values[found - state.names.begin()];
            }
        }
    }
    mean_compression_ = state.mean_compression;
    speed_ = program_.platens ? state.platen_speed : 0;
    platen_.function.value = speed_;
}

StageControllerState StageController::state(double time) const {
    StageControllerState state;
    for (std::size_t c = 0; c < program_.controls.size(); ++c) {
        for (std::size_t i = 0; i < n_actions; ++i) {
            if (numbers_[c][i] != no_amplitude) {
                state.names.push_back(program_.controls[c].name + "." + std::string(name_of(static_cast<Action>(i))));
                state.values.push_back(amplitudes_[numbers_[c][i]].at(time));
            }
        }
    }
    state.platen_speed = speed_;
    state.mean_compression = mean_compression_;
    return state;
}

std::vector<double> StageController::values(double time) const {
    std::vector<double> values;
    std::transform(amplitudes_.begin(), amplitudes_.end(), std::back_inserter(values),
                   [time](const Amplitude& c) { return c.at(time); });
    return values;
}

void StageController::begin(const StageFeedback& f) {
    for (std::size_t c = 0; c < program_.controls.size(); ++c) {
        for (std::size_t i = 0; i < n_actions; ++i) {
            const auto& function = program_.controls[c].start[i];
            if (function) {
                Amplitude& amplitude = amplitudes_[numbers_[c][i]];
                amplitude = {from_present(*function, amplitude.at(f.time)), f.time, amplitude.of_velocity};
            }
        }
    }
    start_stage(f);
}

void StageController::start_stage(const StageFeedback& f) {
    const Stage& stage = now();
    stage_begin_ = f.time;
    functions_end_ = 0;
    quiet_rows_ = 0;
    highest_ = 0;
    const auto set = [&](Amplitude& amplitude, const TimeFunction& function) {
        amplitude = {from_present(function, amplitude.at(f.time)), f.time, amplitude.of_velocity};
        functions_end_ = std::max(functions_end_, f.time + function.end());
    };
    for (std::size_t c = 0; c < program_.controls.size(); ++c) {
        const auto settings = stage.settings.find(program_.controls[c].name);
        for (std::size_t i = 0; i < n_actions && settings != stage.settings.end(); ++i) {
            if (settings->second[i]) {
                set(amplitudes_[numbers_[c][i]], *settings->second[i]);
            }
        }
    }
    if (stage.platen_speed) {
        platen_.function = {};
        platen_.function.value = speed_;  // a ramp starts from the speed of the servo
        servo_ = false;
        set(platen_, *stage.platen_speed);
    } else if (stage.platen_pressure) {
        if (!servo_) {
            platen_.function = {};
            platen_.function.value = mean_compression_;
        }
        servo_ = true;
        set(platen_, *stage.platen_pressure);
    }
    offsets_.clear();
    for (const Condition& condition : stage.until) {
        offsets_.push_back(offset(condition, f));
    }
}

std::string StageController::end_reason(const StageFeedback& f) {
    const Stage& stage = now();
    for (std::size_t i = 0; i < stage.until.size(); ++i) {
        const double off = offset(stage.until[i], f);
        if (off == 0 || (off > 0) != (offsets_[i] > 0)) {
            return stage.until[i].name;
        }
    }
    const double stress = std::abs(last(f, HistoryColumn::axial_stress));
    highest_ = std::max(highest_, stress);
    if (stage.peak_drop && stress < (1 - *stage.peak_drop) * highest_) {
        return "peak_drop";
    }
    if (stage.rest && f.time >= functions_end_) {
        quiet_rows_ = last(f, HistoryColumn::unbalanced_ratio) < *stage.rest ? quiet_rows_ + 1 : 0;
        if (quiet_rows_ >= rest_rows) {
            return "rest";
        }
    }
    // Half a step of round-off must not cost a batch.
    constexpr double round_off = 1e-9;
    return f.time - stage_begin_ >= (1 - round_off) * stage.longest_time ? "time" : "";
}

void StageController::check_stage_end(const StageFeedback& f) {
    if (finished()) {
        return;
    }
    const std::string reason = end_reason(f);
    if (reason.empty()) {
        return;
    }
    records_.push_back({now().name, stage_begin_, f.time, reason});
    ++at_;
    if (!finished()) {
        start_stage(f);
    }
}

void StageController::close(double time, const std::string& reason) {
    if (!finished()) {
        records_.push_back({now().name, stage_begin_, time, reason});
    }
}

double StageController::servo_speed(double time, double duration) const {
    const double rate = (platen_.at(time + duration) - platen_.at(time)) / duration;
    const double lag = platen_.at(time) - mean_compression_;
    const double servo_time = std::max(servo_transits * transit_time_, 4 * duration);
    return 0.5 * height_ / young_modulus_ * (rate + lag / servo_time);
}

IntervalLoading StageController::next(const StageFeedback& f, double duration) {
    IntervalLoading batch;
    batch.amplitudes = &amplitudes_;
    if (!program_.platens) {
        return batch;
    }
    // The servo answers to the stress of the last wave transit: the platens' springs ring too fast for it.
    mean_compression_ += std::min(1.0, duration / transit_time_) * (-last(f, HistoryColumn::axial_stress) - mean_compression_);
    const double begin = servo_ ? speed_ : platen_.at(f.time);
    speed_ = servo_ ? servo_speed(f.time, duration) : platen_.at(f.time + duration);
    batch.velocity_begin = {begin, -begin};
    batch.velocity_end = {speed_, -speed_};
    return batch;
}

}  // namespace graincrack
