// Runs a program stage by stage: sets the functions that boundary conditions and platens follow, and decides when a stage ends.
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

/// A stage that has ended.
struct StageRecord {
    std::string name;
    double begin = 0, end = 0;  ///< s
    std::string ended_by;       ///< name of a `StageEnd`, or why the run ended
};

/// Numbers with their names, as run files store them.
struct NamedNumbers {
    std::vector<std::string> names;
    std::vector<double> values;
};

/// The state of a program between two rows. Another program takes it over; the same program resumes from it.
struct StageControllerState {
    NamedNumbers boundary_conditions;        ///< "boundary.action"; NaN for a free velocity; "temperature"
    double platen_speed = 0;                 ///< m/s
    double mean_compression = 0;             ///< mean that the servo uses, Pa
    NamedNumbers progress;                   ///< all members that change
    std::vector<std::string> stages_end_by;  ///< `StageRecord::ended_by` of the stages that have ended
};

/// Upper bounds of the time that a program takes.
struct LoadingLength {
    double time = 0;           ///< s
    double heating = 0;        ///< part of the time in which the temperature changes at the automatic rate, s
    double usual_heating = 0;  ///< estimate of that part, s
};

class StageController {
public:
    /// \param difference of the free expansions of the minerals (`expansion_difference`), 1/K; 0 if nothing expands
    StageController(const Program& program, const Specimen& specimen, const Rock& rock, double difference = 0);
    /// Takes over the state at the end of another program, before `begin`. Boundary conditions start from the values of those of
    /// the same name. \throws InputError if the state lacks the energy that heat has stored
    void take_over(const StageControllerState& state);
    /// Resumes from a state of the same program. \throws InputError if the state lacks a number
    void resume(const StageControllerState& state);
    [[nodiscard]] StageControllerState state() const;

    /// Begins the program, with its first row.
    void begin(const Feedback& feedback);
    /// Takes a new row and ends the stage if a condition for its end holds. \throws NumericalError for a wrong end
    void check_stage_end(const Feedback& feedback, const Rows& rows);
    /// Starts the next stage, if there is one. It is called once the platens are at their places in that stage.
    void start_next(const Rows& rows);
    /// Ends the present stage, if there is one, for a reason of the run.
    void close(const std::string& reason);
    /// Returns the loading of the next `duration` seconds after the last row.
    /// \throws NumericalError if a loading block does not come to rest
    IntervalLoading next(double duration);
    /// Number of steps to the next row of the history.
    [[nodiscard]] std::int64_t interval_steps(double time_step) const;
    [[nodiscard]] LoadingLength longest() const;

    /// True if the platens have reached their strain limit in a stage that may end so.
    [[nodiscard]] bool is_at_strain_limit() const;
    /// True while the present stage has no platens although the program has some.
    [[nodiscard]] bool is_without_platens() const { return !finished() && now().without_platens; }
    /// True while the present stage changes the temperature at the automatic rate.
    [[nodiscard]] bool heats_automatically() const { return !finished() && thermal_.heats(); }
    [[nodiscard]] bool finished() const { return at_ >= program_.order.size(); }
    [[nodiscard]] const std::vector<StageRecord>& records() const { return records_; }
    /// A sentence on each stage that went far beyond the value that ended it, because rows are far apart.
    [[nodiscard]] const std::vector<std::string>& overshoots() const { return overshoots_; }
    [[nodiscard]] const Feedback& feedback() const { return feedback_; }  ///< of the last row
    [[nodiscard]] const PlatenControl& platens() const { return platens_; }
    /// Completed fraction of the longest time or, if that has no limit, of the strain limit of the platens.
    [[nodiscard]] double progress() const;
    /// Values of the amplitudes at a time (s), for a state that has not moved yet.
    [[nodiscard]] std::vector<double> values(double time) const;

private:
    /// Place of the program that sets the present function of an amplitude: the number of a stage, the start, or none.
    static constexpr int nowhere = -2, at_start = -1;
    /// Calls `act(condition, action, amplitude)` with the indices of each amplitude. The temperature comes last, with the last
    /// condition.
    template <class Act>
    void for_each_amplitude(Act&& act) const;
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit);
    [[nodiscard]] const Stage& now() const { return program_.stage(program_.order[at_]); }
    [[nodiscard]] int number_of(const Stage& stage) const { return static_cast<int>(&stage - program_.stages.data()); }
    /// The function that a place of the program gives an amplitude; empty if there is none.
    [[nodiscard]] std::optional<TimeFunction> written_at(int place, std::size_t condition, std::size_t action) const;
    /// Starts the functions that a place of the program gives.
    void start_functions(int place);
    void start_stage(const Rows& rows);
    [[nodiscard]] double unbalanced_ratio() const { return thermal_.unbalanced_ratio(feedback_); }
    /// Time after which all present functions are constant, s.
    [[nodiscard]] double end_of_functions() const;
    [[noreturn]] void refuse_end(const std::string& reason) const;

    const Program& program_;
    AmplitudeNumbers numbers_;
    std::vector<Amplitude> amplitudes_;
    std::vector<int> origins_;  ///< place of each amplitude's function: a stage, `at_start` or `nowhere`
    PlatenControl platens_;
    int platens_origin_ = nowhere;
    std::size_t at_ = 0;
    bool is_started_ = false;     ///< true once the present stage has started
    double stage_begin_ = 0;      ///< s
    double functions_end_ = 0;    ///< time after which all functions of the stage are constant, s
    std::vector<StageEnd> ends_;  ///< conditions for the end of the present stage
    ThermalStage thermal_;
    std::vector<StageRecord> records_;
    std::vector<std::string> overshoots_;
    Feedback feedback_;  ///< of the last row
};

}  // namespace graincrack
