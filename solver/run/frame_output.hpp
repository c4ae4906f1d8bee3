// Frames of the run file, and which moments become one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "share/file/run_file.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/restart/saved_state.hpp"
#include "solver/run/writing_thread.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// The state as a frame of the run file, in the specimen's own order. Each rank has what it owns of it.
/// \param frame another one of this run, whose memory it takes
Frame make_frame(const Assemblage& assemblage, const ContactLaws& laws, const State& state, ThreadTeam& team, Frame frame = {});

/// Keeps frames evenly spaced while nobody knows how long the run will be, and the one of the peak.
class FrameOutput {
public:
    /// \param requested at least so many evenly spaced frames, 0 for none; in the end there are up to twice as many
    /// \param first_interval of strain, doubled whenever there are too many \param file of the first rank, none on others
    FrameOutput(int requested, double first_interval, const Setup& setup, const State& state, ThreadTeam& team,
                WritingThread* file)
        : requested_(requested), interval_(first_interval), setup_(setup), state_(state), team_(team), file_(file) {}
    /// Resumes where the run of a checkpoint was, with the frames it has.
    void resume(const FrameProgress& progress, const RunReader& checkpoint);
    /// \return writes the frames so far, the state of now last, into a checkpoint, and returns what `resume` needs
    [[nodiscard]] std::function<FrameProgress(const RunWriter& run, RunWriter& checkpoint)> save() const;
    /// Adds a frame when the strain has come to the next interval.
    void regular(double strain);
    /// Remembers the frame of the highest stress so far, and adds it once the stress has clearly fallen.
    void peak(bool is_highest, bool has_fallen);
    void last();
    /// Frames of a run with one peak, at most. \param requested as above
    static constexpr std::size_t max_frames(std::size_t requested) { return requested == 0 ? 1 : 2 * requested + 2; }

private:
    [[nodiscard]] Frame now(Frame frame = {}) const {
        return make_frame(setup_.assemblage, setup_.parameters.laws, state_, team_, std::move(frame));
    }
    /// Brings a frame together on the first rank.
    [[nodiscard]] Frame whole(Frame own) const;
    void thin();
    void add(Frame own, FrameRole role);

    int requested_;
    double interval_;
    const Setup& setup_;
    const State& state_;
    ThreadTeam& team_;
    WritingThread* file_;
    double next_ = 0;
    std::int64_t regular_ = 0;
    std::optional<Frame> peak_;
};

}  // namespace graincrack
