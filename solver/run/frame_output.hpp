// Makes frames of the run file, and decides which times get one.
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

/// The state as a frame of the run file, in the order of the specimen. Each rank has the part that it owns.
/// \param frame another frame of this run, whose memory is used
Frame make_frame(const Assemblage& assemblage, const ContactLaws& laws, const State& state, ThreadTeam& team, Frame frame = {});

/// Keeps evenly spaced frames of a run of unknown length, and the frame of its peak.
class FrameOutput {
public:
    /// \param requested smallest number of evenly spaced frames, 0 for none; a run has up to twice as many
    /// \param first_interval of strain, doubled whenever there are too many \param file on the first rank, null on others
    FrameOutput(int requested, double first_interval, const Setup& setup, const State& state, ThreadTeam& team,
                WritingThread* file)
        : requested_(requested), interval_(first_interval), setup_(setup), state_(state), team_(team), file_(file) {}
    /// Resumes the run of a checkpoint with its frames.
    void resume(const FrameProgress& progress, const RunReader& checkpoint);
    /// \return a function that writes all frames so far and the present state into a checkpoint, and returns the input of
    /// `resume`
    [[nodiscard]] std::function<FrameProgress(const RunWriter& run, RunWriter& checkpoint)> save() const;
    /// Adds a frame when the strain has reached the next interval.
    void regular(double strain);
    /// Stores the frame of the highest stress so far, and adds it once the stress has clearly fallen.
    void peak(bool is_highest, bool has_fallen);
    void last();
    /// Largest number of frames of a run with one peak. \param requested as above
    static constexpr std::size_t max_frames(std::size_t requested) { return requested == 0 ? 1 : 2 * requested + 2; }

private:
    [[nodiscard]] Frame now(Frame frame = {}) const {
        return make_frame(setup_.assemblage, setup_.parameters.laws, state_, team_, std::move(frame));
    }
    /// Gathers a frame on the first rank.
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
