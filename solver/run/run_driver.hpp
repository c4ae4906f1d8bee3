// Who leads a run: one of the four tests or a program. The run itself knows neither.
#pragma once

#include <memory>
#include <string>

#include "solver/loading/stage_control.hpp"
#include "solver/loading/standard_tests.hpp"
#include "solver/run/simulation.hpp"

namespace graincrack {

class H5Output;

/// A run as its leader sees it after each row of the history.
struct RunView {
    const Assemblage& assemblage;
    const Boundary& boundary;
    const State& state;
    const History& history;
    LoadingFeedback feedback;
    double axial_strain = 0;
    double driven_stress = 0;  ///< that the test drives up, positive, Pa
    double peak = 0;           ///< of it, since contacts fail, Pa
    bool cracked = false;      ///< contacts have failed
};

class RunDriver {
public:
    virtual ~RunDriver() = default;
    /// Steps of the next batch, of which each is a row of the history.
    [[nodiscard]] virtual std::int64_t interval_steps(double time_step) const = 0;
    /// Loading of the next `duration` seconds.
    virtual IntervalLoading next(const RunView& view, double duration) = 0;
    /// Takes note of a new row. The first is that of the start.
    virtual void note(const RunView& view) = 0;
    /// Why the run ends here, "" if it goes on.
    [[nodiscard]] virtual std::string stop_reason(const RunView& view) const = 0;
    /// Whether the stress counts as one of the test's.
    [[nodiscard]] virtual bool counts() const = 0;
    [[nodiscard]] virtual double platen_speed() const = 0;  ///< approach of each, m/s
    /// Share of the longest way that is done.
    [[nodiscard]] virtual double progress(const RunView& view) const = 0;
    /// Fills in what it knows of a run that ended for `header.stop_reason`.
    virtual void complete(RunHeader& header, double time) = 0;
    /// Where it is, and going on from where another one was, before the first row.
    [[nodiscard]] virtual StageControllerState saved(double time) const = 0;
    virtual void resume(const StageControllerState& state) = 0;
    /// Or from where a checkpoint of this very run left it, whose rows have been then (of a test all but the last).
    /// \throws InputError for a checkpoint of another program
    virtual void go_on(const StageControllerState& state, const RunReader& checkpoint, double time_step) = 0;
    /// What the run file gets of its rows from `first` on, besides the history.
    virtual void append(H5Output& file, std::size_t first) const = 0;
    /// And at the end.
    virtual void write(H5Output& file) const = 0;
};

/// \throws InputError where a program does not fit the specimen
std::unique_ptr<RunDriver> make_run_driver(const SimulationRequest& request, const Assemblage& assemblage,
                                           const Specimen& specimen);

}  // namespace graincrack
