// The state of a run at its end, kept in its file (/state), so that another run starts from it: to the byte with the same
// values, or with other contact values or another program.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "share/file/run_file.hpp"
#include "solver/loading/stage_control.hpp"
#include "solver/model/state.hpp"
#include "solver/setup/setup.hpp"

namespace graincrack {

class H5Output;

/// The position of the choice of frames, for a run that resumes from a checkpoint.
struct FrameProgress {
    double next = 0;               ///< progress at which the next regular frame is due
    double interval = 0;           ///< from one regular frame to the next
    std::int64_t regular = 0;      ///< how many there are
    std::vector<FrameRole> roles;  ///< of the frames of the checkpoint
};

/// Writes /state: everything of a state that is not found anew from the rest, where its loading was, and the SHA-256 of it all.
/// \param frames of a checkpoint
void write_saved_state(H5Output& file, const State& state, const StageControllerState& loading, double energy_balance_error,
                       std::optional<FrameProgress> frames = {});

/// The start of a run that continues another.
struct SavedState {
    State state;
    StageControllerState loading;
    std::vector<Crack> cracks;
    FrameProgress frames;             ///< of a checkpoint
    double energy_scale = 0;          ///< largest stored energy so far, J
    double energy_balance_error = 0;  ///< largest so far, J
};

/// Reads the end of the run `path`. Its specimen, rock, plane and mass scaling must be those of `setup`; contact values and time
/// step may be others: what the change puts into the contacts' stored energy counts as external work. \throws InputError if the
/// run keeps no state, one that does not fit, or one that is not what was written
SavedState read_saved_state(const std::string& path, const Specimen& specimen, const SimulationRequest& request,
                            const Setup& setup);

}  // namespace graincrack
