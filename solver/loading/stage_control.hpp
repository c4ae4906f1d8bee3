// Leads a program through its stages: which function each boundary condition and the platens follow now, and when a stage ends.
#pragma once

#include <string>
#include <vector>

#include "share/file/run_file.hpp"
#include "solver/loading/platen_control.hpp"
#include "solver/loading/stage_ends.hpp"
#include "solver/loading/thermal_stage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/program/program.hpp"
#include "solver/setup/regions.hpp"

namespace graincrack {

/// A stage that has been.
struct StageRecord {
    std::string name;
    double begin = 0, end = 0;  ///< s
    std::string ended_by;       ///< name of a `StageEnd`, or why the run ended
};

/// Numbers with their names, as files keep them.
struct NamedNumbers {
    std::vector<std::string> names;
    std::vector<double> values;
};

/// The position of a program: another program takes it over, the same program resumes with it.
struct StageControllerState {
    NamedNumbers boundary_conditions;        ///< "boundary.action"; NaN for a free velocity; "temperature"
    double platen_speed = 0;                 ///< m/s
    double mean_compression = 0;             ///< as the servo sees it, Pa
    NamedNumbers progress;                   ///< everything that changes
    std::vector<std::string> stages_end_by;  ///< of the stages that have been
};

/// The longest that a program takes.
struct LoadingLength {
    double time = 0;           ///< s
    double heating = 0;        ///< part of the time in which the measures decide how fast the temperature changes, s
    double usual_heating = 0;  ///< about what that takes, s
};

class StageController {
public:
    /// \param difference of the free expansions of the minerals (`expansion_difference`), 1/K; 0 where nothing expands
    StageController(const Program& program, const Specimen& specimen, const Rock& rock, double difference = 0);
    /// Takes over what another program left, before `begin`: its boundary conditions, those of the same name, start from its
    /// values.
    void take_over(const StageControllerState& state);
    /// Resumes where the same program was.
    void resume(const StageControllerState& state);
    [[nodiscard]] StageControllerState state() const;

    /// Begins the program, with its first row.
    void begin(const Feedback& feedback);
    /// Records a new row: ends the stage if it has reached an end. \throws NumericalError if it is not the end that it must have
    void check_stage_end(const Feedback& feedback, const Rows& rows);
    /// Starts the stage that is to come, if there is one: to be called once the platens are where it has them.
    void start_next(const Rows& rows);
    /// Ends the stage that is on, if there is one, for a reason of the run.
    void close(const std::string& reason);
    /// Loading of the next `duration` seconds after the last row.
    /// \throws NumericalError if a loading block does not come to rest
    IntervalLoading next(double duration);
    /// Steps to the next row of the history.
    [[nodiscard]] std::int64_t interval_steps(double time_step) const;
    [[nodiscard]] LoadingLength longest() const;

    /// True if the platens have come to their strain limit in a stage that may end so.
    [[nodiscard]] bool is_at_strain_limit() const;
    /// True while a stage is on that has no platens, though the program has some.
    [[nodiscard]] bool is_without_platens() const { return !finished() && now().without_platens; }
    /// True while a stage is on that changes the temperature as fast as the measures allow.
    [[nodiscard]] bool heats_automatically() const { return !finished() && thermal_.heats(); }
    [[nodiscard]] bool finished() const { return at_ >= program_.order.size(); }
    [[nodiscard]] const std::vector<StageRecord>& records() const { return records_; }
    /// A sentence on each stage that went far beyond the value that ended it, since rows are few.
    [[nodiscard]] const std::vector<std::string>& overshoots() const { return overshoots_; }
    [[nodiscard]] const Feedback& feedback() const { return feedback_; }  ///< of the last row
    [[nodiscard]] const PlatenControl& platens() const { return platens_; }
    /// Share that is done: of the longest time or, where that has no limit, of the largest strain of the platens.
    [[nodiscard]] double progress() const;
    /// Values of the amplitudes at a time, for a state that has not moved yet.
    [[nodiscard]] std::vector<double> values(double time) const;

private:
    /// The place in which the present function of an amplitude is written: in a stage, at the start of the program, or nowhere.
    static constexpr int nowhere = -2, at_start = -1;
    /// Calls `act(condition, action, amplitude)` with the places of each; the last is that of the temperature, whose condition is
    /// behind the others.
    template <class Act>
    void for_each_amplitude(Act&& act) const;
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit);
    [[nodiscard]] const Stage& now() const { return program_.stage(program_.order[at_]); }
    [[nodiscard]] int number_of(const Stage& stage) const { return static_cast<int>(&stage - program_.stages.data()); }
    /// The function of an amplitude that is written at a place, if there is one.
    [[nodiscard]] std::optional<TimeFunction> written_at(int place, std::size_t condition, std::size_t action) const;
    /// Starts the functions that are written at a place.
    void start_functions(int place);
    void start_stage(const Rows& rows);
    [[nodiscard]] double unbalanced_ratio() const { return thermal_.unbalanced_ratio(feedback_); }
    /// When the functions that run now change no more, s.
    [[nodiscard]] double end_of_functions() const;
    [[noreturn]] void refuse_end(const std::string& reason) const;

    const Program& program_;
    AmplitudeNumbers numbers_;
    std::vector<Amplitude> amplitudes_;
    std::vector<int> origins_;  ///< of the amplitudes' functions: a stage, `at_start` or `nowhere`
    PlatenControl platens_;
    int platens_origin_ = nowhere;
    std::size_t at_ = 0;
    bool is_started_ = false;     ///< the stage that is on
    double stage_begin_ = 0;      ///< s
    double functions_end_ = 0;    ///< of all that run in the stage, s
    std::vector<StageEnd> ends_;  ///< of the stage that is on
    ThermalStage thermal_;
    std::vector<StageRecord> records_;
    std::vector<std::string> overshoots_;
    Feedback feedback_;  ///< of the last row
};

}  // namespace graincrack
