#include "solver/loading/stage_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "share/base/error.hpp"
#include "share/file/specimen_measures.hpp"
#include "solver/program/keys.hpp"

namespace graincrack {
namespace {

// Chosen by trial:
constexpr double rows_of_longest_time = 8000;        // rows in the longest time
constexpr std::int64_t min_steps_of_stage_row = 10;  // fewest steps between two rows
constexpr double max_transits_between_rows = 0.5;    // at an automatic change of the temperature, and in short stages
/// The platens of a program; platens that do not move if it has none.
ProgramPlatens platens_of(const Program& program) {
    if (program.platens) return *program.platens;
    ProgramPlatens none;
    none.max_strain = 0;
    return none;
}

/// The value of this name; null if there is none.
const double* find_value(const NamedNumbers& numbers, const std::string& name) {
    const auto at = std::find(numbers.names.begin(), numbers.names.end(), name);
    return at == numbers.names.end() ? nullptr : &numbers.values[static_cast<std::size_t>(at - numbers.names.begin())];
}
const double& value_of(const NamedNumbers& numbers, const std::string& name) {
    if (const double* const value = find_value(numbers, name)) return *value;
    throw InputError(fmt::format("the saved state of the loading lacks \"{}\"; only a run's own checkpoint has it", name));
}

std::string name_of_amplitude(const Program& program, std::size_t condition, std::size_t action) {
    if (condition == program.boundary_conditions.size()) return program_keys::temperature;
    return program.boundary_conditions[condition].name + "." + std::string(name_of(static_cast<Action>(action)));
}

}  // namespace

StageController::StageController(const Program& program, const Specimen& specimen, const Rock& rock, double difference)
    : program_(program),
      numbers_(number_amplitudes(program)),
      platens_(specimen, rock, platens_of(program)),
      thermal_(program, specimen, rock, difference) {
    for_each_amplitude([&](std::size_t, std::size_t action, std::size_t) {
        const bool of_velocity = is_velocity(static_cast<Action>(action));
        TimeFunction free;
        free.value = of_velocity ? NAN : 0;
        amplitudes_.push_back({free, 0, of_velocity});
        origins_.push_back(nowhere);
    });
}

template <class Act>
void StageController::for_each_amplitude(Act&& act) const {
    for (std::size_t c = 0; c < program_.boundary_conditions.size(); ++c) {
        for (std::size_t i = 0; i < n_actions; ++i) {
            if (numbers_[c][i] != no_amplitude) act(c, i, static_cast<std::size_t>(numbers_[c][i]));
        }
    }
    if (program_.has_temperature()) act(program_.boundary_conditions.size(), n_actions, amplitudes_.size() - 1);
}

std::optional<TimeFunction> StageController::written_at(int place, std::size_t condition, std::size_t action) const {
    const bool is_temperature = condition == program_.boundary_conditions.size();
    if (place == at_start) return is_temperature ? program_.temperature : program_.boundary_conditions[condition].start[action];
    const Stage& stage = program_.stages[place];
    if (is_temperature) return stage.temperature;
    const auto settings = stage.settings.find(program_.boundary_conditions[condition].name);
    return settings == stage.settings.end() ? std::nullopt : settings->second[action];
}

// --- what a run resumes with -------------------------------------------------------------------------------------------------

template <class Self, class Visit>
void StageController::visit_state(Self& self, Visit&& visit) {
    visit("stage", self.at_);
    visit("stage_begin", self.stage_begin_);
    visit("functions_end", self.functions_end_);
    visit("feedback.time", self.feedback_.time);
    visit("feedback.axial_compression", self.feedback_.axial_compression);
    visit("feedback.unbalanced_ratio", self.feedback_.unbalanced_ratio);
    visit("feedback.kinetic_energy", self.feedback_.kinetic_energy);
    visit("feedback.stored_energy", self.feedback_.stored_energy);
    visit("feedback.force_difference", self.feedback_.force_difference);
    visit("feedback.damping_load", self.feedback_.damping_load);
    visit("feedback.near_failure", self.feedback_.near_failure);
    for (std::size_t i = 0; i < self.amplitudes_.size(); ++i) {
        const std::string name = fmt::format("amplitude{}.", i);
        visit(name + "origin", self.origins_[i]);
        visit(name + "from", self.amplitudes_[i].function.from);
        visit(name + "value", self.amplitudes_[i].function.value);
        visit(name + "start", self.amplitudes_[i].start);
        const bool has_rate = self.amplitudes_[i].function.kind == TimeFunction::Kind::rate;
        if (has_rate) visit(name + "rate", self.amplitudes_[i].function.rate);
    }
    if (self.thermal_.is_thermal()) {
        visit("feedback.element_force", self.feedback_.element_force);
        ThermalStage::visit_state(self.thermal_, visit);
    }
    for (auto& end : self.ends_) {
        if (!end.memory_name.empty()) visit(end.memory_name, end.memory);
    }
    for (std::size_t i = 0; i < self.records_.size(); ++i) {
        visit(fmt::format("stage{}.begin", i), self.records_[i].begin);
        visit(fmt::format("stage{}.end", i), self.records_[i].end);
    }
    visit("platens.origin", self.platens_origin_);
    PlatenControl::visit_state(self.platens_, visit);
}

void StageController::take_over(const StageControllerState& state) {
    for_each_amplitude([&](std::size_t condition, std::size_t action, std::size_t amplitude) {
        const std::string name = name_of_amplitude(program_, condition, action);
        const double* const value = find_value(state.boundary_conditions, name);
        if (value != nullptr) amplitudes_[amplitude].function.value = *value;
    });
    platens_.take_over(program_.platens ? state.platen_speed : 0, state.mean_compression);
    if (find_value(state.boundary_conditions, program_keys::temperature) == nullptr) return;
    const double* const has_moved = find_value(state.progress, "platens_moved");
    thermal_.take_over(has_moved != nullptr && *has_moved != 0 ? &value_of(state.progress, "locked_in") : nullptr);
}

void StageController::resume(const StageControllerState& state) {
    const auto index_of = [&](const std::string& name) { return static_cast<int>(value_of(state.progress, name)); };
    at_ = static_cast<std::size_t>(index_of("stage"));
    for (std::size_t i = 0; i < at_; ++i) records_.push_back({program_.order[i], 0, 0, state.stages_end_by[i]});
    if (!finished()) ends_ = ends_of(now(), nullptr);
    for_each_amplitude([&](std::size_t condition, std::size_t action, std::size_t i) {
        origins_[i] = index_of(fmt::format("amplitude{}.origin", i));
        if (origins_[i] != nowhere) amplitudes_[i].function = written_at(origins_[i], condition, action).value();
    });
    if (find_value(state.progress, "locked_in") != nullptr) thermal_.set_thermal();
    if (!finished()) thermal_.resume(now());
    platens_origin_ = index_of("platens.origin");
    platens_.take_over(state.platen_speed, state.mean_compression);
    if (platens_origin_ != nowhere) platens_.set(*program_.stages[platens_origin_].platens, 0);
    is_started_ = true;
    visit_state(*this, [&](const std::string& name, auto& member) {
        member = static_cast<std::decay_t<decltype(member)>>(value_of(state.progress, name));
    });
}

StageControllerState StageController::state() const {
    StageControllerState state;
    for_each_amplitude([&](std::size_t condition, std::size_t action, std::size_t amplitude) {
        state.boundary_conditions.names.push_back(name_of_amplitude(program_, condition, action));
        state.boundary_conditions.values.push_back(amplitudes_[amplitude].at(feedback_.time));
    });
    state.platen_speed = platens_.speed();
    state.mean_compression = platens_.mean_compression();
    visit_state(*this, [&](const std::string& name, const auto& member) {
        state.progress.names.push_back(name);
        state.progress.values.push_back(static_cast<double>(member));
    });
    std::transform(records_.begin(), records_.end(), std::back_inserter(state.stages_end_by),
                   [](const StageRecord& record) { return record.ended_by; });
    return state;
}

std::vector<double> StageController::values(double time) const {
    std::vector<double> values;
    std::transform(amplitudes_.begin(), amplitudes_.end(), std::back_inserter(values),
                   [time](const Amplitude& c) { return c.at(time); });
    return values;
}

// --- stages ----------------------------------------------------------------------------------------------------------------

void StageController::begin(const Feedback& feedback) {
    feedback_ = feedback;
    start_functions(at_start);
    is_started_ = false;
}

void StageController::start_next(const Rows& rows) {
    if (finished() || is_started_) return;
    start_stage(rows);
    is_started_ = true;
}

void StageController::start_functions(int place) {
    for_each_amplitude([&](std::size_t condition, std::size_t action, std::size_t i) {
        const std::optional<TimeFunction> function = written_at(place, condition, action);
        if (!function) return;
        amplitudes_[i] = {starting_from(*function, amplitudes_[i].at(feedback_.time)), feedback_.time,
                          amplitudes_[i].of_velocity};
        origins_[i] = place;
    });
}

void StageController::start_stage(const Rows& rows) {
    const Stage& stage = now();
    stage_begin_ = feedback_.time;
    start_functions(number_of(stage));
    thermal_.begin(stage, program_.has_temperature() ? &amplitudes_.back() : nullptr, feedback_, rows.history);
    if (stage.platens) {
        platens_.set(*stage.platens, feedback_.time);
        platens_origin_ = number_of(stage);
    }
    functions_end_ = end_of_functions();
    ends_ = ends_of(stage, &rows);
}

void StageController::refuse_end(const std::string& reason) const {
    throw NumericalError(fmt::format(
        "{}: stage {}: ended by {}, not by {}: the unbalanced ratio is {:.2e}, the axial pressure {:.2f} % off what the platens "
        "hold; use more --damping, a slower rate or a longer time",
        program_.file, now().name, reason, now().must_end_by, unbalanced_ratio(), 100 * platens_.pressure_error(feedback_.time)));
}

void StageController::check_stage_end(const Feedback& feedback, const Rows& rows) {
    feedback_ = feedback;
    if (finished()) return;
    const bool is_heated = thermal_.is_thermal();
    const StageRow row{feedback_,
                       rows,
                       stage_begin_,
                       functions_end_,
                       unbalanced_ratio(),
                       platens_.pressure_error(feedback_.time),
                       platens_.transit_time(),
                       thermal_.cracks_before(),
                       is_heated,
                       is_heated ? platens_.settling_stress() : 0};
    const auto end = std::find_if(ends_.begin(), ends_.end(), [&](StageEnd& e) { return e.is_reached(row, e.memory); });
    if (end == ends_.end()) return;
    const std::string reason = end->name;
    if (!now().must_end_by.empty() && reason != now().must_end_by) refuse_end(reason);
    records_.push_back({now().name, stage_begin_, feedback_.time, reason});
    if (const double share = overshoot(now(), reason, rows); share > trusted_overshoot) {
        overshoots_.push_back(
            fmt::format("stage {} went {:.1f} % beyond its end by {}: give it a slower motion or, in the program, "
                        "a smaller row_every",
                        now().name, 100 * share, reason));
    }
    ++at_;
    is_started_ = false;
}

void StageController::close(const std::string& reason) {
    if (!finished()) records_.push_back({now().name, stage_begin_, feedback_.time, reason});
}

// --- intervals -------------------------------------------------------------------------------------------------------------

double StageController::end_of_functions() const {
    double end = std::max(feedback_.time, platens_.function_end());
    for (const Amplitude& a : amplitudes_) end = std::max(end, a.start + a.function.end());
    return end;
}

IntervalLoading StageController::next(double duration) {
    if (heats_automatically() && !thermal_.heat(feedback_, duration, amplitudes_.back())) functions_end_ = end_of_functions();
    IntervalLoading interval;
    interval.amplitudes = &amplitudes_;
    if (program_.has_temperature()) interval.temperature = static_cast<std::int32_t>(amplitudes_.size()) - 1;
    if (program_.platens) {
        const PlatenSpeeds speeds = platens_.next(thermal_.of_load(feedback_, platens_), duration);
        interval.velocity_begin = {speeds.begin, -speeds.begin};
        interval.velocity_end = {speeds.end, -speeds.end};
    }
    return interval;
}

std::int64_t StageController::interval_steps(double time_step) const {
    const double longest_time = program_.longest_time();
    const bool by_platens = !program_.row_interval && !std::isfinite(longest_time);
    if (heats_automatically()) {
        const double most = max_transits_between_rows * platens_.transit_time() / time_step;
        return std::max(min_steps_of_stage_row, static_cast<std::int64_t>(most));
    }
    if (by_platens || platens_.paces_rows()) return platens_.interval_steps(time_step);
    // A short stage beside a long one has rows of its own, but no closer than `max_transits_between_rows`.
    const double of_stage = std::max(max_transits_between_rows * platens_.transit_time(),
                                     finished() ? longest_time : now().longest_time / rows_of_longest_time);
    const double interval = program_.row_interval.value_or(std::min(longest_time / rows_of_longest_time, of_stage));
    return std::max<std::int64_t>(program_.row_interval ? 1 : min_steps_of_stage_row, std::llround(interval / time_step));
}

LoadingLength StageController::longest() const {
    PlatenControl platens = platens_;
    LoadingLength length;
    double temperature = 0;
    for (const std::string& name : program_.order) {
        const Stage& stage = program_.stage(name);
        if (stage.platens) platens.set(*stage.platens, 0);
        const double time = std::isfinite(stage.longest_time) ? stage.longest_time : platens.longest_time();
        if (stage.heating) {
            length.heating += time;
            length.usual_heating += thermal_.usual_time(*stage.heating, std::abs(stage.heating->to - temperature));
        }
        if (stage.temperature) temperature = stage.temperature->value;
        length.time += time;
    }
    return length;
}

bool StageController::is_at_strain_limit() const {
    if (!program_.platens || (!finished() && !now().must_end_by.empty())) return false;
    return std::abs(feedback_.axial_strain) >= program_.platens->max_strain;
}

double StageController::progress() const {
    const double longest_time = program_.longest_time();
    if (std::isfinite(longest_time)) {
        const double begin = records_.empty() ? stage_begin_ : records_.front().begin;
        return (feedback_.time - begin) / longest_time;
    }
    return std::abs(feedback_.axial_strain) / program_.platens->max_strain;
}

}  // namespace graincrack
