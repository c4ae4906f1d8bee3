// Checkpoints: what a long test writes beside its run file now and then, from which another run resumes to the same end.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "share/file/run_file.hpp"

namespace graincrack {

/// The name of the checkpoints of a run: "run.h5.checkpoint".
inline std::string checkpoint_of(const std::string& output) { return output + ".checkpoint"; }

/// Wall time since something was last done.
class WallClock {
public:
    /// \param seconds what a clock shows, s
    explicit WallClock(std::function<double()> seconds) : seconds_(std::move(seconds)) {}
    [[nodiscard]] double elapsed() const { return seconds_() - begin_; }  ///< s
    void restart() { begin_ = seconds_(); }

private:
    std::function<double()> seconds_;
    double begin_ = seconds_();
};

/// Clears the name of the checkpoints of a new run: another one of that name is refused unless it is to be discarded.
/// \param restart file that the run resumes from, "" without \throws UsageError
void clear_checkpoint_name(const std::string& checkpoint, const std::string& restart, bool discard);
/// Removes a checkpoint, whole or not.
void remove_checkpoint(const std::string& checkpoint);

/// From here on SIGUSR1, by which schedulers warn, asks for a checkpoint and does not end the program.
void catch_checkpoint_signal();
/// True if it has asked since the last call.
bool take_checkpoint_request() noexcept;

/// True if a run file is a checkpoint, of a run that has not ended.
bool is_checkpoint(const RunReader& run);

/// True if a test as in `now` resumes from a checkpoint of one as in `before`: all that decides its course must be the same but
/// for where it ends. \param name of the checkpoint \throws InputError naming the option that differs, or for a run that has
/// ended
void require_same_test(const std::string& name, const RunHeader& before, const RunHeader& now);

}  // namespace graincrack
