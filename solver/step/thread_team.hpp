// A team of threads that work together on many steps. Each thread has a share (step_shares.hpp); a barrier separates stages.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace graincrack {

/// Barrier for a fixed number of threads. It spins for a short time. If the other threads do not arrive by then, because
/// processors are busy or fewer than threads, it sleeps and releases the processor.
class SpinBarrier {
public:
    explicit SpinBarrier(int n_threads) : n_threads_(n_threads) {}
    void wait() {
        if (n_threads_ == 1) return;
        const std::uint32_t generation = generation_.load(std::memory_order_acquire);
        if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == n_threads_) {
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
    const int n_threads_;
    alignas(64) std::atomic<int> arrived_{0};
    alignas(64) std::atomic<std::uint32_t> generation_{0};
    alignas(64) std::atomic<bool> patient_{true};
};

/// Threads that live as long as the team. Between two calls of `run` they wait at a barrier and sleep if that takes long.
class ThreadTeam {
public:
    explicit ThreadTeam(int n_threads);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;
    [[nodiscard]] int size() const { return static_cast<int>(others_.size()) + 1; }
    /// Runs `work(thread)` for every thread 0 … size − 1, thread 0 in the caller; returns when all are done.
    void run(const std::function<void(int)>& work);
    /// Separates stages of `work`: returns when all threads of the team have called it.
    void wait() { barrier_.wait(); }

private:
    SpinBarrier barrier_;
    const std::function<void(int)>* work_ = nullptr;  ///< null: the team ends
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
