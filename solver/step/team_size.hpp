// How many threads of a team work where other programs use the processors too. Threads wait for each other several times a step,
// so that one without a processor stops all: fewer threads are then faster.
#pragma once

#include <cstdint>

namespace graincrack {

/// Time that a thread waited for a processor although it could run, as Linux tells it (/proc/thread-self/schedstat, second
/// number); 0 where it does not. What a virtual machine's host takes away is not in it.
class QueueTime {
public:
    QueueTime() = default;
    ~QueueTime();
    QueueTime(const QueueTime&) = delete;
    QueueTime& operator=(const QueueTime&) = delete;
    /// Begins with the calling thread.
    void begin();
    /// s since the last call, or since `begin`; any thread may ask.
    double since_last();

private:
    int file_ = -1;
    std::int64_t last_ = 0;  // ns
};

/// The number of threads at work, decided by the share of the time that they waited for processors. Numbers below are chosen by
/// trial: alone on its processors a team waits less than 1 % of the time, with one busy program beside two threads 20 to 50 %.
class TeamSize {
public:
    static constexpr double shortest_interval = 0.02;  ///< between decisions, s: several slices of a scheduler

    explicit TeamSize(int most) : size_(most), most_(most) {}
    /// \param interval since the last decision, s
    /// \param queued mean share of the interval that the threads at work waited for processors
    /// \return number of threads for the next interval: fewer by the share if it is above a tenth. If it is below a fiftieth, a
    /// quarter more, one at least, after a pause of 1 s, which doubles up to 32 s with each trial that fails.
    int next(double interval, double queued);

private:
    int size_;
    int most_;
    double pause_ = 1;        // s
    double undisturbed_ = 0;  // s
};

}  // namespace graincrack
