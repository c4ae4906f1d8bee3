#include "solver/loading/stage_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "share/base/error.hpp"
#include "share/file/specimen_measures.hpp"
#include "solver/program/keys.hpp"

namespace graincrack {
namespace {

constexpr int rest_rows = 5;                   // in succession that must be at rest: one may be so by chance
constexpr double rows_of_longest_time = 8000;  // of the longest time
constexpr double wave_transits = 2;            // of a wave, to the other platen and back
constexpr std::int64_t min_steps_of_stage_row = 10;
constexpr double least_thermal_load = 0.2;       // thermal stress that counts, of the tensile strength
constexpr double max_transits_of_heating = 0.5;  // between rows while measures decide how fast the temperature changes

/// Distance of a condition from being reached, with its side.
double offset(const Condition& c, const Rows& rows) {
    return (c.probe.empty() ? rows.history.columns[c.column].back() : rows.probe(c.probe, c.column)) - c.value;
}

/// Contacts that have failed so far.
double cracks_in(const History& history) {
    return history[HistoryColumn::tensile_cracks].back() + history[HistoryColumn::shear_cracks].back();
}

/// Platens that go nowhere if it has none.
ProgramPlatens platens_of(const Program& program) {
    if (program.platens) return *program.platens;
    ProgramPlatens none;
    none.max_strain = 0;
    return none;
}

/// The value of a name; null if it is missing.
const double* find_value(const NamedNumbers& numbers, const std::string& name) {
    const auto at = std::find(numbers.names.begin(), numbers.names.end(), name);
    return at == numbers.names.end() ? nullptr : &numbers.values[static_cast<std::size_t>(at - numbers.names.begin())];
}
double value_of(const NamedNumbers& numbers, const std::string& name) {
    if (const double* const value = find_value(numbers, name)) return *value;
    throw InputError(fmt::format("the saved state of the loading lacks \"{}\"; only a run's own checkpoint has it", name));
}

/// Σ |force of the elements on a node| under a uniform stress, N: each node has the mean of two sides of an element.
HeatingScales heating_scales(const Specimen& s, const Rock& rock, double difference) {
    const double stress = least_thermal_load * rock.tensile_strength;
    double sides = 0;
    for (const auto& nodes : s.element_nodes) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& from = s.node_position[static_cast<std::size_t>(nodes[i])];
            const auto& to = s.node_position[static_cast<std::size_t>(nodes[(i + 1) % 3])];
            sides += std::hypot(to[0] - from[0], to[1] - from[1]);
        }
    }
    return {bar_transit_time(s, rock), difference > 0 ? stress / (rock.young_modulus * difference) : 1, stress * sides / 2};
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
      heating_scales_(heating_scales(specimen, rock, difference)),
      heating_(default_rate_tolerance, heating_scales_),
      is_thermal_(program.has_temperature()) {
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
    visit("rows_at_rest", self.rows_at_rest_);
    visit("highest", self.highest_);
    visit("feedback.time", self.feedback_.time);
    visit("feedback.axial_compression", self.feedback_.axial_compression);
    visit("feedback.unbalanced_ratio", self.feedback_.unbalanced_ratio);
    visit("feedback.kinetic_energy", self.feedback_.kinetic_energy);
    visit("feedback.stored_energy", self.feedback_.stored_energy);
    visit("feedback.rate.unbalanced_ratio", self.feedback_.unbalanced_ratio);  // the same: files have both names
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
    if (self.is_thermal_) {
        visit("feedback.element_force", self.feedback_.element_force);
        visit("heats", self.heats_);
        visit("heating_from", self.heating_from_);
        visit("locked_in", self.locked_in_);
        visit("cracks_before", self.cracks_before_);
        HeatingControl::visit_state(self.heating_, visit);
    }
    for (std::size_t i = 0; i < self.offsets_.size(); ++i) visit(fmt::format("offset{}", i), self.offsets_[i]);
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
    is_thermal_ = is_thermal_ || find_value(state.boundary_conditions, program_keys::temperature) != nullptr;
}

void StageController::resume(const StageControllerState& state) {
    const auto index_of = [&](const std::string& name) { return static_cast<int>(value_of(state.progress, name)); };
    at_ = static_cast<std::size_t>(index_of("stage"));
    for (std::size_t i = 0; i < at_; ++i) records_.push_back({program_.order[i], 0, 0, state.stages_end_by[i]});
    offsets_.resize(finished() ? 0 : now().until.size());
    for_each_amplitude([&](std::size_t condition, std::size_t action, std::size_t i) {
        origins_[i] = index_of(fmt::format("amplitude{}.origin", i));
        if (origins_[i] != nowhere) amplitudes_[i].function = written_at(origins_[i], condition, action).value();
    });
    is_thermal_ = find_value(state.progress, "locked_in") != nullptr;
    if (!finished() && now().heating) heating_ = heating_control(*now().heating);
    platens_origin_ = index_of("platens.origin");
    platens_.take_over(state.platen_speed, state.mean_compression);
    if (platens_origin_ != nowhere) platens_.set(*program_.stages[platens_origin_].platens, 0);
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

void StageController::begin(const Feedback& feedback, const Rows& rows) {
    feedback_ = feedback;
    start_functions(at_start);
    start_stage(rows);
}

void StageController::start_functions(int place) {
    functions_end_ = 0;
    for_each_amplitude([&](std::size_t condition, std::size_t action, std::size_t i) {
        const std::optional<TimeFunction> function = written_at(place, condition, action);
        if (!function) return;
        amplitudes_[i] = {starting_from(*function, amplitudes_[i].at(feedback_.time)), feedback_.time,
                          amplitudes_[i].of_velocity};
        origins_[i] = place;
        functions_end_ = std::max(functions_end_, feedback_.time + amplitudes_[i].function.end());
    });
}

void StageController::start_stage(const Rows& rows) {
    const Stage& stage = now();
    stage_begin_ = feedback_.time;
    rows_at_rest_ = 0;
    highest_ = 0;
    start_functions(number_of(stage));
    heats_ = stage.heating.has_value();
    if (heats_) {
        heating_ = heating_control(*stage.heating);
        heating_from_ = amplitudes_.back().function.from;
    }
    const bool was_heated = at_ == 0 || program_.stage(program_.order[at_ - 1]).temperature;
    if (is_thermal_ && stage.platens && was_heated) locked_in_ = feedback_.stored_energy;
    cracks_before_ = is_thermal_ ? cracks_in(rows.history) : 0;
    if (stage.platens) {
        platens_.set(*stage.platens, feedback_.time);
        platens_origin_ = number_of(stage);
        functions_end_ = std::max(functions_end_, platens_.function_end());
    }
    offsets_.clear();
    for (const Condition& condition : stage.until) offsets_.push_back(offset(condition, rows));
}

bool StageController::is_at_rest(double tolerance) {
    const bool rests = feedback_.time >= functions_end_ && unbalanced_ratio() < tolerance &&
                       std::abs(platens_.pressure_error(feedback_.time)) < tolerance;
    rows_at_rest_ = rests ? rows_at_rest_ + 1 : 0;
    return rows_at_rest_ >= rest_rows;
}

double StageController::unbalanced_ratio() const {
    return is_thermal_ ? heating_scales_.loaded(feedback_) : feedback_.unbalanced_ratio;
}

bool StageController::fails(double stress, const History& history) const {
    const double cracks = cracks_in(history);
    // Where a specimen cracked before the test, the load at which its faces settle is no peak.
    return cracks > cracks_before_ && (!is_thermal_ || stress >= platens_.settling_stress());
}

// Without damping waves do not die out: what one of them takes from the load, less than its time to and fro, is no fall.
bool StageController::has_fallen_below(double stress, const History& history) const {
    const std::vector<double>& time = history[HistoryColumn::time];
    const bool is_damped = history[HistoryColumn::energy_damping].back() > 0;
    const double since = time.back() - (is_damped ? 0 : wave_transits * platens_.transit_time());
    std::size_t row = history.size() - 1;
    while (row > 0 && time[row] > since && std::abs(history[HistoryColumn::axial_stress][row]) < stress) --row;
    return std::abs(history[HistoryColumn::axial_stress][row]) < stress;
}

std::string StageController::end_reason(const Rows& rows) {
    const Stage& stage = now();
    for (std::size_t i = 0; i < stage.until.size(); ++i) {
        const double off = offset(stage.until[i], rows);
        if (off == 0 || (off > 0) != (offsets_[i] > 0)) return stage.until[i].name;
    }
    const double stress = std::abs(feedback_.axial_compression);
    if (highest_ > 0 || fails(stress, rows.history)) highest_ = std::max(highest_, stress);
    if (stage.peak_drop && has_fallen_below((1 - *stage.peak_drop) * highest_, rows.history)) return "peak_drop";
    if (stage.rest && is_at_rest(*stage.rest)) return ended_by_rest;
    // Half a step of round-off must not cost an interval.
    constexpr double round_off = 1e-9;
    return feedback_.time - stage_begin_ >= (1 - round_off) * stage.longest_time ? "time" : "";
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
    const std::string reason = end_reason(rows);
    if (reason.empty()) return;
    if (!now().must_end_by.empty() && reason != now().must_end_by) refuse_end(reason);
    records_.push_back({now().name, stage_begin_, feedback_.time, reason});
    ++at_;
    if (!finished()) start_stage(rows);
}

void StageController::close(const std::string& reason) {
    if (!finished()) records_.push_back({now().name, stage_begin_, feedback_.time, reason});
}

// --- intervals -------------------------------------------------------------------------------------------------------------

void StageController::heat(double duration) {
    Amplitude& temperature = amplitudes_.back();
    const double present = temperature.at(feedback_.time);
    const double left = std::abs(temperature.function.value - present);
    if (left > 0) {
        temperature = {starting_from(temperature.function, present), feedback_.time, false};
        temperature.function.rate = heating_.next(feedback_, std::abs(present - heating_from_), left, duration);
        return;
    }
    heats_ = false;
    functions_end_ = std::max(feedback_.time, platens_.function_end());
    for (const Amplitude& a : amplitudes_) functions_end_ = std::max(functions_end_, a.start + a.function.end());
}

IntervalLoading StageController::next(double duration) {
    if (heats_automatically()) heat(duration);
    IntervalLoading interval;
    interval.amplitudes = &amplitudes_;
    if (program_.has_temperature()) interval.temperature = static_cast<std::int32_t>(amplitudes_.size()) - 1;
    if (program_.platens) {
        Feedback feedback = feedback_;
        feedback.stored_energy -= locked_in_;
        if (is_thermal_ && platens_.settling_stress() > 0) {
            const double share = std::min(1.0, std::abs(feedback.axial_compression) / platens_.settling_stress());
            feedback.force_difference *= share;  // both over a load that is none yet
            feedback.damping_load *= share;
        }
        const PlatenSpeeds speeds = platens_.next(feedback, duration);
        interval.velocity_begin = {speeds.begin, -speeds.begin};
        interval.velocity_end = {speeds.end, -speeds.end};
    }
    return interval;
}

std::int64_t StageController::interval_steps(double time_step) const {
    const double longest_time = program_.longest_time();
    const bool by_platens = !program_.row_interval && !std::isfinite(longest_time);
    if (heats_automatically()) {
        const double most = max_transits_of_heating * platens_.transit_time() / time_step;
        return std::max(min_steps_of_stage_row, static_cast<std::int64_t>(most));
    }
    if (by_platens || platens_.paces_rows()) return platens_.interval_steps(time_step);
    const double interval = program_.row_interval.value_or(longest_time / rows_of_longest_time);
    return std::max<std::int64_t>(program_.row_interval ? 1 : min_steps_of_stage_row, std::llround(interval / time_step));
}

LoadingLength StageController::longest(double time_step) const {
    StageController ahead(*this);
    LoadingLength length;
    double temperature = 0;
    for (const std::string& name : program_.order) {
        const Stage& stage = program_.stage(name);
        if (stage.platens) ahead.platens_.set(*stage.platens, 0);
        const bool has_end = std::isfinite(stage.longest_time);
        const double time = has_end ? stage.longest_time : ahead.platens_.longest_time();
        if (stage.heating) {
            length.heating += time;
            length.usual_heating += heating_control(*stage.heating).usual_time(std::abs(stage.heating->to - temperature));
        }
        if (stage.temperature) temperature = stage.temperature->value;
        const double interval = static_cast<double>(ahead.interval_steps(time_step)) * time_step;
        length.time += time;
        length.rows += static_cast<std::size_t>(time / interval + (has_end ? 1 : rows_of_longest_time));
    }
    return length;
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
