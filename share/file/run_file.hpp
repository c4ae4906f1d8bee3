// Run files, which the solver writes and the postprocessor reads. A file repeats the specimen and adds /run, /history, /cracks
// and /frames.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "share/file/crack.hpp"
#include "share/file/history.hpp"
#include "share/file/run_header.hpp"
#include "share/file/sensitivity.hpp"
#include "share/file/specimen.hpp"

namespace graincrack {

/// State of the assemblage at one time; array lengths n, e, c as in Specimen.
struct Frame {
    double time = 0;
    std::int64_t step = 0;
    std::vector<std::array<double, 2>> displacement;    ///< [n] m
    std::vector<std::array<double, 2>> velocity;        ///< [n] m/s
    std::vector<std::array<double, 4>> element_stress;  ///< [e] xx yy xy zz, Pa
    std::vector<std::array<double, 2>> opening;         ///< [c] at points 0 and 1, m
    std::vector<std::array<double, 2>> sliding;         ///< [c] m
    std::vector<std::array<double, 4>> traction;        ///< [c] (normal, shear) at point 0 and at point 1; dataset [c,2,2], Pa
    std::vector<std::array<double, 2>> damage;          ///< [c] 0 to 1
    std::vector<std::array<std::uint8_t, 2>> state;     ///< [c] PointState
};

/// Role of a frame during a run.
enum class FrameRole : std::uint8_t {
    regular,      ///< evenly spaced; every second one is removed when there are too many
    kept,         ///< kept: the frame of a peak, or the last one
    peak_so_far,  ///< in a checkpoint: kept unless a higher peak follows
    present       ///< in a checkpoint: the state at the checkpoint, not a frame of the run
};

/// Writes a run while it is computed. Frames are thinned during the run, so that it ends with between `frames` and 2 × `frames`
/// evenly spaced ones, plus those marked to keep (peak, last).
class RunWriter {
public:
    /// \param file an output of kind "run"; specimen and header are written at once
    RunWriter(H5Output file, const Specimen& specimen, const RunHeader& header);

    /// Appends rows [already written, history.size()) of the history and flushes.
    void append_history(const History& history);
    void add_frame(const Frame& frame, FrameRole role);
    /// Adds the frames of another run, with their roles.
    void add_frames(const RunWriter& other);
    /// Removes every second regular frame.
    void thin_frames();
    /// Roles of the frames in time order.
    [[nodiscard]] std::vector<FrameRole> frame_roles() const;
    [[nodiscard]] std::size_t n_frames() const { return frames_.size(); }
    /// The open file, for further groups of a run.
    [[nodiscard]] H5Output& file() { return file_; }
    /// Writes the final header, the crack log and the sensitivity if there is one, numbers the frames in time order, links the
    /// last frame into /VTKHDF, writes /provenance and commits the file.
    void finish(const RunHeader& header, const std::vector<Crack>& cracks, const struct Provenance& provenance,
                const std::vector<SensitivityRow>& sensitivity = {});

private:
    struct Slot {
        std::string group;
        double time;
        FrameRole role;
    };
    std::string next_group();

    H5Output file_;
    std::size_t rows_ = 0;      ///< rows of the history already written
    std::size_t n_groups_ = 0;  ///< groups of frames so far; they are renumbered in time order at the end
    std::vector<Slot> frames_;  ///< in time order; the frame of a peak may be added after later ones
};

/// Reads a run; arrays are read on request.
class RunReader {
public:
    /// \param path a run file or "-" \throws InputError
    explicit RunReader(const std::string& path);

    [[nodiscard]] const std::string& name() const { return file_.name(); }
    [[nodiscard]] const RunHeader& header() const { return header_; }
    [[nodiscard]] Specimen specimen() const;
    [[nodiscard]] History history() const;
    [[nodiscard]] std::vector<Crack> cracks() const { return read_cracks(file_); }
    [[nodiscard]] std::size_t n_frames() const { return frames_.size(); }
    /// Time of each frame, ascending, s.
    [[nodiscard]] std::vector<double> frame_times() const;
    [[nodiscard]] Frame frame(std::size_t index) const;
    [[nodiscard]] double wall_time() const;  ///< from /provenance, s
    [[nodiscard]] int threads() const;
    [[nodiscard]] const H5Input& file() const { return file_; }

private:
    H5Input file_;
    RunHeader header_;
    std::vector<std::string> frames_;  ///< their groups
};

}  // namespace graincrack
