// Who uses the file of a run while the run goes on: HDF5 serves one thread at a time.
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <utility>

#include "share/file/run_file.hpp"

namespace graincrack {

/// The file of a run on the first rank. What is large is compressed and written by a thread of its own while the run goes on,
/// one piece of work at a time. There is no other way to the file, and the caller uses HDF5 only after `when_done`. What a piece
/// of work throws, the next `when_done` or `later` throws.
class WritingThread {
public:
    /// \param has_thread whether there is one; else the caller does all work
    WritingThread(std::unique_ptr<RunWriter> file, bool has_thread) : file_(std::move(file)), has_thread_(has_thread) {}
    /// Begins a piece of work when the one before is done. \param work (RunWriter&) with copies of all that changes in a run
    template <class Work>
    void later(Work work) {
        RunWriter& file = when_done();
        if (!has_thread_) return work(file);
        work_ = std::async(std::launch::async, [&file, work = std::move(work)] {
            silence_hdf5();
            work(file);
        });
    }
    [[nodiscard]] bool is_done() const {
        return !work_.valid() || work_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }
    /// Waits until all work is done. \return the file, for the caller until it gives the next piece
    RunWriter& when_done() {
        if (work_.valid()) work_.get();
        return *file_;
    }

private:
    std::unique_ptr<RunWriter> file_;
    bool has_thread_;
    std::future<void> work_;  ///< its end waits for the thread
};

}  // namespace graincrack
