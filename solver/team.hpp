// A team of threads that walk through many steps together: contiguous shares of blocks and a cheap barrier.
#pragma once

#include <sched.h>

#include <atomic>
#include <cstdint>

#include "solver/assemblage.hpp"

namespace graincrack {

/// Barrier for a fixed number of threads. Spins briefly, then lets others run, so that it also works with more threads
/// than processors.
class SpinBarrier {
public:
    explicit SpinBarrier(int n_threads) : n_threads_(n_threads) {}
    void wait() {
        if (n_threads_ == 1) {
            return;
        }
        const std::uint32_t generation = generation_.load(std::memory_order_acquire);
        if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == n_threads_) {
            arrived_.store(0, std::memory_order_relaxed);
            generation_.store(generation + 1, std::memory_order_release);
            return;
        }
        for (int spins = 0; generation_.load(std::memory_order_acquire) == generation; ++spins) {
            if (spins > 4000) {
                sched_yield();
            } else {
#if defined(__x86_64__)
                __builtin_ia32_pause();
#endif
            }
        }
    }

private:
    const int n_threads_;
    alignas(64) std::atomic<int> arrived_{0};
    alignas(64) std::atomic<std::uint32_t> generation_{0};
};

/// Share of thread `thread` of `n` items.
inline Range share_of(std::size_t n, int thread, int n_threads) {
    const auto at = [&](int t) {
        return static_cast<std::int32_t>(n * static_cast<std::size_t>(t) / static_cast<std::size_t>(n_threads));
    };
    return {at(thread), at(thread + 1)};
}

}  // namespace graincrack
