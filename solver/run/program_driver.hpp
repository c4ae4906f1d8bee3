// A program at work in a run: its stages, its probes, and what the run file keeps of both.
#pragma once

#include <optional>
#include <string>

#include "solver/loading/stage_control.hpp"
#include "solver/run/probes.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

class H5Output;

class ProgramDriver {
public:
    /// \param test that the program is, or `TestKind::program`
    /// \throws InputError where a program does not fit the specimen
    ProgramDriver(const Program& program, TestKind test, const Assemblage& assemblage, const Specimen& specimen,
                  const Rock& rock);

    [[nodiscard]] const StageController& stages() const { return stages_; }
    /// Loading of the next `duration` seconds.
    IntervalLoading next(double duration) { return stages_.next(duration); }
    /// Records a new row, after `measure`, and ends the stage that it ends. The first row is that of the start.
    void record(const Assemblage& assemblage, const Boundary& boundary, const State& state, const History& history,
                const Feedback& feedback);
    /// Starts the stage that is to come, if there is one.
    void start_next(const History& history) { stages_.start_next(rows_of(history)); }
    /// Why the run ends here, "" if it continues.
    [[nodiscard]] std::string stop_reason() const;
    /// Fills in what it knows of a run that ended for `header.stop_reason`.
    void complete(RunHeader& header);
    /// Continues where another program ended, before the first row.
    void take_over(const StageControllerState& state);
    /// Resumes from a checkpoint of this very program. \throws InputError for one of another program
    void resume(const StageControllerState& state, const RunReader& checkpoint);
    /// Appends to the run file its rows from `first` on, besides the history; of a standard test without probes nothing.
    void append(H5Output& file, std::size_t first) const;
    /// And at the end.
    void write(H5Output& file) const;

private:
    [[nodiscard]] bool is_standard() const { return test_ != TestKind::program; }
    /// The membrane of a standard test is in its history already.
    [[nodiscard]] bool keeps_probes() const { return !is_standard() || !program_.probes.empty(); }
    [[nodiscard]] Rows rows_of(const History& history) const {
        return {history, [this](const std::string& name, std::size_t column) { return probes_.last(name, column); }};
    }

    const Program& program_;
    TestKind test_;
    StageController stages_;
    Probes probes_;
    std::optional<StageControllerState> started_from_;
    bool begun_ = false;
};

}  // namespace graincrack
