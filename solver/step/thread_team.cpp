#include "solver/step/thread_team.hpp"

namespace graincrack {

ThreadTeam::ThreadTeam(int n_threads) : barrier_(n_threads) {
    for (int thread = 1; thread < n_threads; ++thread) {
        others_.emplace_back([this, thread] {
            for (barrier_.wait(); work_ != nullptr; barrier_.wait()) {
                (*work_)(thread);
                barrier_.wait();
            }
        });
    }
}

ThreadTeam::~ThreadTeam() {
    work_ = nullptr;
    barrier_.wait();
    for (std::thread& thread : others_) thread.join();
}

void ThreadTeam::run(const std::function<void(int)>& work) {
    work_ = &work;
    barrier_.wait();
    work(0);
    barrier_.wait();
}

}  // namespace graincrack
