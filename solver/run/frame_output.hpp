// Frames of the run file, and which moments become one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "share/file/run_file.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/state.hpp"
#include "solver/restart/saved_state.hpp"

namespace graincrack {

/// The state as a frame of the run file, in the specimen's own order. Each rank has what it owns of it.
Frame make_frame(const Assemblage& assemblage, const ContactLaws& laws, const State& state);
/// Brings a frame together on the first rank.
Frame whole_frame(const Assemblage& assemblage, Frame own);

/// Keeps frames evenly spaced while nobody knows how long the run will be, and the one of the peak.
class FrameOutput {
public:
    /// \param requested at least so many evenly spaced frames, 0 for none; in the end there are up to twice as many
    /// \param first_interval of strain, doubled whenever there are too many \param writer of the first rank, none on others
    FrameOutput(int requested, double first_interval, RunWriter* writer);
    /// Resumes where the run of a checkpoint was, with the frames it has.
    void resume(const FrameProgress& progress, const RunReader& checkpoint);
    /// Writes the frames so far, the state of now last, into a checkpoint. \return what `resume` needs
    FrameProgress save(const Assemblage& assemblage, const ContactLaws& laws, const State& state, RunWriter* checkpoint) const;
    /// Adds a frame when the strain has come to the next interval. \return whether it has
    bool regular(double strain, const Assemblage& assemblage, const ContactLaws& laws, const State& state);
    /// Remembers the frame of the highest stress so far, and adds it once the stress has clearly fallen. \return whether it has
    bool peak(bool is_highest, bool has_fallen, const Assemblage& assemblage, const ContactLaws& laws, const State& state);
    void last(const Assemblage& assemblage, const ContactLaws& laws, const State& state);
    /// Frames of a run with one peak, at most. \param requested as above
    static constexpr std::size_t max_frames(std::size_t requested) { return requested == 0 ? 1 : 2 * requested + 2; }

private:
    void thin_if_too_many();
    void add(const Assemblage& assemblage, Frame own, FrameRole role);

    int requested_;
    double interval_;
    RunWriter* writer_;
    double next_ = 0;
    std::int64_t regular_ = 0;
    std::optional<Frame> peak_;
};

}  // namespace graincrack
