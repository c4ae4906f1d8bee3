// A program as the leader of a run: its conductor, its probes, and what the run file keeps of both.
#pragma once

#include <optional>

#include "solver/run/probes.hpp"
#include "solver/run/run_driver.hpp"

namespace graincrack {

class ProgramDriver : public RunDriver {
public:
    ProgramDriver(const Program& program, const Assemblage& assemblage, const Specimen& specimen, const Rock& rock);

    [[nodiscard]] std::int64_t interval_steps(double time_step) const override;
    IntervalLoading next(const RunView& view, double duration) override;
    void note(const RunView& view) override;
    [[nodiscard]] std::string stop_reason(const RunView& view) const override;
    [[nodiscard]] bool counts() const override { return true; }
    [[nodiscard]] double platen_speed() const override { return stage_controller_.platen_speed(); }
    [[nodiscard]] double progress(const RunView& view) const override;
    void complete(RunHeader& header, double time) override;
    [[nodiscard]] StageControllerState saved(double time) const override { return stage_controller_.state(time); }
    void resume(const StageControllerState& state) override;
    /// Leads the conductor through the checkpoint's rows again: what it decides follows from them alone.
    void go_on(const StageControllerState& state, const RunReader& checkpoint, double time_step) override;
    void append(H5Output& file, std::size_t first) const override;
    void write(H5Output& file) const override;

private:
    template <class Act>
    void with_feedback(const RunView& view, Act&& act);

    const Program& program_;
    StageController stage_controller_;
    Probes probes_;
    std::optional<StageControllerState> started_from_;
    bool begun_ = false;
    double begin_ = 0;  ///< s
};

/// Steps between two rows of a program's history: its own `row_every`, or the 8000th part of its longest time.
std::int64_t program_interval_steps(const Program& program, double time_step);

}  // namespace graincrack
