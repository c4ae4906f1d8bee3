// Checkpoints: what a long test writes beside its run file now and then, for another run to go on to the same end.
#pragma once

#include <chrono>
#include <string>

#include "share/run_file.hpp"

namespace graincrack {

/// Where the checkpoints of a run lie: "run.h5.checkpoint".
inline std::string checkpoint_of(const std::string& output) { return output + ".checkpoint"; }

/// Tells when the next checkpoint is due, by the wall clock.
class CheckpointClock {
public:
    /// \param interval s
    explicit CheckpointClock(double interval) : interval_(interval) {}
    /// Whether it is; if so, the next one is an interval later.
    [[nodiscard]] bool is_due() {
        const auto now = std::chrono::steady_clock::now();
        const bool due = now - last_ >= interval_;
        last_ = due ? now : last_;
        return due;
    }

private:
    std::chrono::duration<double> interval_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// From here on SIGUSR1, by which schedulers warn, asks for a checkpoint and does not end the program.
void catch_checkpoint_signal();
/// Whether it has asked since the last call.
bool take_checkpoint_request() noexcept;

/// Whether a run file is a checkpoint, of a run that has not ended. \throws InputError if it is no run file
bool is_checkpoint(const std::string& path);

/// Whether a test as in `now` goes on from a checkpoint of one as in `before`: all that decides its course must be the same but
/// for where it ends. \param name of the checkpoint \throws InputError naming the option that differs, or for a run that has
/// ended
void require_same_test(const std::string& name, const RunHeader& before, const RunHeader& now);

}  // namespace graincrack
