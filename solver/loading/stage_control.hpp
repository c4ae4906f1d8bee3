// Leads a program through its stages: which function each control and the platens follow now, and when a stage ends.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "share/run_file.hpp"
#include "solver/model/boundary.hpp"
#include "solver/setup/program.hpp"
#include "solver/setup/regions.hpp"

namespace graincrack {

/// What the stages are judged by: the last row of the history and of the probes.
struct StageFeedback {
    double time = 0;
    const History& history;
    const std::function<double(const std::string& probe, std::size_t column)>& probe;
};

/// A stage that has been.
struct StageRecord {
    std::string name;
    double begin = 0, end = 0;  ///< s
    std::string ended_by;       ///< "time", "rest", "peak_drop" or the name of a condition
};

/// What goes on from one program to the next (a saved state).
struct StageControllerState {
    std::vector<std::string> names;  ///< of values: "control.action"
    std::vector<double> values;      ///< NaN for a free velocity
    double platen_speed = 0;         ///< m/s
    double mean_compression = 0;     ///< as the servo sees it, Pa
};

class StageController {
public:
    StageController(const Program& program, const Specimen& specimen, const Rock& rock);
    /// Takes over what another program left, before `begin`: its controls, those of the same name, start from its values.
    void resume(const StageControllerState& state);
    [[nodiscard]] StageControllerState state(double time) const;

    /// Starts the first stage.
    void begin(const StageFeedback& feedback);
    /// Ends the stage if it has reached an end, and starts the next one.
    void check_stage_end(const StageFeedback& feedback);
    /// Ends the stage that is on, if there is one, for a reason of the run.
    void close(double time, const std::string& reason);
    /// Loading of the next `duration` seconds. Its channels are those of this conductor.
    IntervalLoading next(const StageFeedback& feedback, double duration);

    [[nodiscard]] bool finished() const { return at_ >= program_.order.size(); }
    [[nodiscard]] const std::vector<StageRecord>& records() const { return records_; }
    [[nodiscard]] double platen_speed() const { return speed_; }  ///< at the end of the last batch, approach positive, m/s
    /// Values of the channels at a time, for a state that has not moved yet.
    [[nodiscard]] std::vector<double> values(double time) const;

private:
    [[nodiscard]] const Stage& now() const { return program_.stage(program_.order[at_]); }
    void start_stage(const StageFeedback& feedback);
    [[nodiscard]] std::string end_reason(const StageFeedback& feedback);
    [[nodiscard]] double servo_speed(double time, double duration) const;

    const Program& program_;
    AmplitudeNumbers numbers_;
    std::vector<Amplitude> amplitudes_;
    std::size_t at_ = 0;
    double stage_begin_ = 0;       ///< s
    double functions_end_ = 0;     ///< of those the stage set, s
    int quiet_rows_ = 0;           ///< at rest, in succession
    double highest_ = 0;           ///< axial stress of the stage, absolute, Pa
    std::vector<double> offsets_;  ///< of its conditions at its begin
    std::vector<StageRecord> records_;
    double height_;
    double transit_time_;  ///< of a bar wave through the specimen, s
    double young_modulus_;
    Amplitude platen_;  ///< speed, or pressure with a servo
    bool servo_ = false;
    double mean_compression_ = 0;  ///< over about a transit, Pa
    double speed_ = 0;
};

}  // namespace graincrack
