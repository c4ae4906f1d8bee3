// A team of threads that work together on many steps. Each thread has a share (step_shares.hpp); a barrier separates stages.
// On processors that other programs use too, the team has fewer threads at work (team_size.hpp).
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

#include "solver/step/team_size.hpp"

namespace graincrack {

/// Barrier for a number of threads. It spins for a short time. If the other threads do not arrive by then, because
/// processors are busy or fewer than threads, it sleeps and releases the processor.
class SpinBarrier {
public:
    explicit SpinBarrier(int n_threads) : n_threads_(n_threads) {}
    /// Changes the number; to be called by a thread for which the others of the new number wait at the barrier.
    void resize(int n_threads) { n_threads_.store(n_threads, std::memory_order_release); }
    void wait() {
        if (n_threads_.load(std::memory_order_acquire) == 1) return;
        const std::uint32_t generation = generation_.load(std::memory_order_acquire);
        if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == n_threads_.load(std::memory_order_acquire)) {
            arrived_.store(0, std::memory_order_relaxed);
            generation_.store(generation + 1, std::memory_order_release);
            generation_.notify_all();
            return;
        }
        // Every `waits_between_trials` waits it tests whether the others arrive during a long spin.
        const bool patient = patient_.load(std::memory_order_relaxed) || generation % waits_between_trials == 0;
        for (int spins = patient ? patient_spins : impatient_spins; spins > 0; --spins) {
            if (generation_.load(std::memory_order_acquire) != generation) {
                if (patient) patient_.store(true, std::memory_order_relaxed);
                return;
            }
#if defined(__x86_64__)
            __builtin_ia32_pause();
#endif
        }
        patient_.store(false, std::memory_order_relaxed);
        while (generation_.load(std::memory_order_acquire) == generation) generation_.wait(generation, std::memory_order_acquire);
    }

private:
    static constexpr int patient_spins = 20000;  // about 250 µs, the longest serial work between two parallel stages
    static constexpr int impatient_spins = 100;
    static constexpr std::uint32_t waits_between_trials = 64;
    std::atomic<int> n_threads_;
    alignas(64) std::atomic<int> arrived_{0};
    alignas(64) std::atomic<std::uint32_t> generation_{0};
    alignas(64) std::atomic<bool> patient_{true};
};

/// Threads that live as long as the team. Between two calls of `run` they wait at a barrier and sleep if that takes long.
class ThreadTeam {
public:
    explicit ThreadTeam(int most);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;
    /// Number of threads at work.
    [[nodiscard]] int size() const { return active_; }
    [[nodiscard]] int most() const { return static_cast<int>(others_.size()) + 1; }
    /// Mean number at work, by time between calls of `adapt`.
    [[nodiscard]] double mean_size() const { return time_ > 0 ? thread_time_ / time_ : size(); }
    /// Runs `work(thread)` for every thread 0 … size − 1, thread 0 in the caller; returns when all are done.
    void run(const std::function<void(int)>& work);
    /// Separates stages of `work`: returns when all threads of the team have called it.
    void wait() { barrier_.wait(); }
    /// Between two calls of `run`: parks threads that wait for processors, and tries from time to time whether there are more.
    void adapt();
    /// Between two calls of `run`. \pre 1 ≤ n ≤ most
    void resize(int n);

private:
    using Clock = std::chrono::steady_clock;
    void work_as(int thread);

    SpinBarrier barrier_;
    const std::function<void(int)>* work_ = nullptr;  ///< null: the team ends
    std::atomic<int> active_;
    std::atomic<int> parked_{0};
    TeamSize team_size_;
    std::vector<QueueTime> queues_;  ///< one a thread
    Clock::time_point decided_ = Clock::now();
    double time_ = 0;         ///< s
    double thread_time_ = 0;  ///< s, times the threads at work
    std::vector<std::thread> others_;
};

/// Calls `act` with 0 … n − 1, shared by the threads of a team; returns when all are done.
template <class Act>
void for_each_of_team(ThreadTeam& team, std::size_t n, const Act& act) {
    team.run([&](int thread) {
        const auto first = [&](int t) { return n * static_cast<std::size_t>(t) / static_cast<std::size_t>(team.size()); };
        for (std::size_t i = first(thread); i < first(thread + 1); ++i) act(i);
    });
}

}  // namespace graincrack
