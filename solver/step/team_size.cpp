#include "solver/step/team_size.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace graincrack {

QueueTime::~QueueTime() {
    if (file_ >= 0) close(file_);
}

void QueueTime::begin() {
    file_ = open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC);
    since_last();
}

double QueueTime::since_last() {
    char text[96] = {};
    long long queued = 0;
    if (file_ < 0 || pread(file_, text, sizeof text - 1, 0) <= 0 || std::sscanf(text, "%*d %lld", &queued) != 1) return 0;
    const double time = 1e-9 * static_cast<double>(queued - last_);
    last_ = queued;
    return time;
}

int TeamSize::next(double interval, double queued) {
    constexpr double busy = 0.1;
    constexpr double quiet = 0.02;
    constexpr double longest_pause = 32;
    undisturbed_ = queued < quiet ? undisturbed_ + interval : 0;
    if (queued > busy && size_ > 1) {
        size_ = std::max(1, static_cast<int>(size_ * (1 - queued)));
        pause_ = std::min(2 * pause_, longest_pause);
        undisturbed_ = 0;
    } else if (size_ < most_ && undisturbed_ > pause_) {
        size_ = std::min(most_, size_ + std::max(1, size_ / 4));
        undisturbed_ = 0;
    } else if (size_ == most_ && undisturbed_ > longest_pause) {
        pause_ = 1;
    }
    return size_;
}

}  // namespace graincrack
