// The run file as it grows, and its checkpoints.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "share/file/provenance.hpp"
#include "share/file/run_file.hpp"
#include "solver/restart/checkpoint.hpp"
#include "solver/restart/saved_state.hpp"
#include "solver/run/frame_output.hpp"
#include "solver/run/program_driver.hpp"
#include "solver/run/recorder.hpp"
#include "solver/run/writing_thread.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// The parts of a run, as its files keep it.
struct Run {
    const Specimen& specimen;
    const SimulationRequest& request;
    const Setup& setup;
    const ProgramDriver& program;
    const State& state;
    const Recorder& recorder;
    const RunHeader& header;
    ThreadTeam& team;
    Provenance provenance;  ///< without the wall time
};

/// The first rank writes; the others bring it what they own.
class RunOutput {
public:
    /// \param output file, "-" for stdout \param frames of the checkpoint that the run resumes from, if it does
    /// \throws UsageError if something else has the name of the run or of its checkpoint
    RunOutput(Run run, const std::string& output, const std::optional<FrameProgress>& frames);
    /// Takes the last row: frames, and from time to time the rows so far.
    void record();
    /// True if a checkpoint is due, or was asked for. The first rank decides.
    [[nodiscard]] bool wants_checkpoint();
    /// From one checkpoint to the next at least, s: ten times what one takes, so that they cost a run a tenth of its time at
    /// most.
    [[nodiscard]] double least_checkpoint_interval() const { return 10 * checkpoint_time_; }
    /// Writes a run file of its own, with all rows, cracks and frames so far and the present state, while the run goes on.
    /// \return its name, "" for a run that has none
    const std::string& write_checkpoint();
    /// Why the last checkpoint could not be written, once that is known; a run goes on without it, and one that stops does not.
    [[nodiscard]] std::string checkpoint_problem() const { return file_ && file_->is_done() ? checkpoint_problem_ : ""; }
    /// Waits until the last checkpoint is written. \throws OutputError
    void require_checkpoint() {
        ranks_.on_first([&] {
            file_->when_done();
            if (!checkpoint_problem_.empty()) throw OutputError(checkpoint_problem_);
        });
    }
    /// Waits until all that was to be written is. To be called by all ranks before other files are opened.
    void wait() {
        ranks_.on_first([&] { file_->when_done(); });
    }
    /// Completes the file. \param wall_time of the run, s
    void finish(const std::vector<SensitivityRow>& sensitivity, double wall_time);

private:
    void append_rows();

    Run run_;
    const Ranks& ranks_;
    std::string checkpoint_;               ///< its file, "" for none
    std::string checkpoint_problem_;       ///< told by the thread of `file_`, which ends before it does
    std::unique_ptr<WritingThread> file_;  ///< on the first rank
    FrameOutput frames_;
    std::size_t rows_written_ = 0;
    WallClock since_checkpoint_, since_flush_;
    bool writes_checkpoint_ = false;
    double checkpoint_time_ = 0;  ///< that the last one took, s
};

}  // namespace graincrack
