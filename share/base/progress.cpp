#include "share/base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

constexpr double terminal_interval = 0.2;  // s between two prints
constexpr double log_interval = 30.0;      // s, where stderr is no terminal
constexpr int bar_width = 24;

std::string clock_text(double seconds) {
    const long s = std::lround(seconds);
    return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60) : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

}  // namespace

Progress::Progress(std::string label, Verbosity verbosity)
    : label_(std::move(label)),
      verbosity_(verbosity),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      last_print_(start_) {}

Progress::~Progress() { finish(); }

void Progress::update(double share, const std::string& detail) {
    if (verbosity_ == Verbosity::quiet) return;
    const auto now = std::chrono::steady_clock::now();
    const bool due = seconds_between(last_print_, now) >= (terminal_ ? terminal_interval : log_interval);
    if (!due) return;
    last_print_ = now;
    share = std::clamp(share, 0.0, 1.0);
    const double elapsed = seconds_between(start_, now);
    const std::string left = share > 0.005 ? clock_text(elapsed / share * (1 - share)) : std::string("?");
    if (terminal_) {
        const auto filled = static_cast<std::size_t>(share * bar_width);
        const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
        tell(fmt::format("\r\033[K{} [{}] {:3.0f} %, {}, at most {} left", label_, bar, 100 * share, detail, left));
        std::fflush(stderr);
        open_ = true;
    } else {
        tell(fmt::format("{}: {:.0f} %, {}, at most {} left\n", label_, 100 * share, detail, left));
    }
}

void Progress::finish() {
    if (open_) {
        tell("\r\033[K");
        std::fflush(stderr);
        open_ = false;
    }
    verbosity_ = Verbosity::quiet;
}

}  // namespace graincrack
