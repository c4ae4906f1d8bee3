#include "solver/step/thread_team.hpp"

namespace graincrack {

ThreadTeam::ThreadTeam(int most) : barrier_(most), active_(most), team_size_(most), queues_(static_cast<std::size_t>(most)) {
    queues_[0].begin();
    for (int thread = 1; thread < most; ++thread) others_.emplace_back([this, thread] { work_as(thread); });
    run([](int /*thread*/) {});  // so that all have begun
}

ThreadTeam::~ThreadTeam() {
    resize(most());
    work_ = nullptr;
    barrier_.wait();
    for (std::thread& thread : others_) thread.join();
}

void ThreadTeam::work_as(int thread) {
    queues_[static_cast<std::size_t>(thread)].begin();
    for (barrier_.wait(); work_ != nullptr; barrier_.wait()) {
        if (thread < active_) {
            (*work_)(thread);
            barrier_.wait();
            continue;
        }
        ++parked_;
        parked_.notify_one();
        for (int active = active_; active <= thread; active = active_) active_.wait(active);
        --parked_;
        parked_.notify_one();
    }
}

void ThreadTeam::run(const std::function<void(int)>& work) {
    work_ = &work;
    barrier_.wait();
    work(0);
    barrier_.wait();
}

void ThreadTeam::resize(int n) {
    if (n > active_) {
        barrier_.resize(n);  // those at work wait for this thread
        active_ = n;
        active_.notify_all();
    } else if (n < active_) {
        const std::function<void(int)> nothing = [](int /*thread*/) {};
        work_ = &nothing;
        active_ = n;
        barrier_.wait();
        barrier_.resize(n);
        barrier_.wait();
    }
    // Who is to park has done so before there can be other work.
    for (int parked = parked_; parked != most() - n; parked = parked_) parked_.wait(parked);
}

void ThreadTeam::adapt() {
    const double time = std::chrono::duration<double>(Clock::now() - decided_).count();
    if (most() == 1 || time < TeamSize::shortest_interval) return;
    double queued = 0;
    for (int thread = 0; thread < size(); ++thread) queued += queues_[static_cast<std::size_t>(thread)].since_last() / size();
    time_ += time;
    thread_time_ += time * size();
    const int next = team_size_.next(time, queued / time);
    if (next != size()) {
        resize(next);
        for (QueueTime& queue : queues_) queue.since_last();  // what a thread waited before or for its parking counts no more
    }
    decided_ = Clock::now();
}

}  // namespace graincrack
