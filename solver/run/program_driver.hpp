// A program at work in a run: its stages, its probes, and what the run file keeps of both.
#pragma once

#include <optional>
#include <string>

#include "solver/loading/stage_control.hpp"
#include "solver/run/probes.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

class H5Output;

/// What a program sees of a run after each row of the history.
struct RunView {
    const Assemblage& assemblage;
    const Boundary& boundary;
    const State& state;
    const History& history;
    RateMeasures rate;
    double axial_strain = 0;
};

class ProgramDriver {
public:
    /// \param test that the program is, or `TestKind::program`
    /// \throws InputError where a program does not fit the specimen
    ProgramDriver(const Program& program, TestKind test, const Assemblage& assemblage, const Specimen& specimen,
                  const Rock& rock);

    /// Steps of the next interval; its end is a row of the history.
    [[nodiscard]] std::int64_t interval_steps(double time_step) const { return stages_.interval_steps(time_step); }
    /// The longest that the program may take.
    [[nodiscard]] LoadingLength longest(double time_step) const { return stages_.longest(time_step); }
    /// Loading of the next `duration` seconds.
    IntervalLoading next(double duration) { return stages_.next(duration); }
    /// Records a new row. The first is that of the start.
    void note(const RunView& view);
    /// Why the run ends here, "" if it goes on.
    [[nodiscard]] std::string stop_reason(double axial_strain) const;
    [[nodiscard]] double platen_speed() const { return stages_.platens().speed(); }  ///< approach of each, m/s
    /// Share of the longest way that is done.
    [[nodiscard]] double progress(const RunView& view) const { return stages_.progress(view.state.time, view.axial_strain); }
    /// Fills in what it knows of a run that ended for `header.stop_reason`.
    void complete(RunHeader& header, double time);
    /// Where it is: continued from the place of another program, before the first row, and from a checkpoint of this very one.
    /// \throws InputError for a checkpoint of another program
    [[nodiscard]] StageControllerState saved(double time) const { return stages_.state(time); }
    void resume(const StageControllerState& state);
    void go_on(const StageControllerState& state, const RunReader& checkpoint);
    /// What the run file gets of its rows from `first` on, besides the history; of a standard test nothing.
    void append(H5Output& file, std::size_t first) const;
    /// Bytes of a row of that.
    [[nodiscard]] std::size_t size_of_row() const;
    /// And at the end.
    void write(H5Output& file) const;

private:
    [[nodiscard]] bool is_standard() const { return test_ != TestKind::program; }

    const Program& program_;
    TestKind test_;
    StageController stages_;
    Probes probes_;
    std::optional<StageControllerState> started_from_;
    bool begun_ = false;
};

}  // namespace graincrack
