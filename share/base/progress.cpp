#include "share/base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace graincrack {
namespace {

constexpr double shortest_interval = 0.2;  // s; least time between events, and between prints on a terminal
constexpr double log_interval = 30.0;      // s; if stderr is no terminal
constexpr int bar_width = 24;

std::string clock_text(double seconds) {
    const long s = std::lround(seconds);
    return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60) : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

void show(const std::string& text) {
    static_cast<void>(std::fputs(text.c_str(), stderr));
    std::fflush(stderr);
}

}  // namespace

Progress::Progress(std::string label, Verbosity verbosity)
    : label_(std::move(label)),
      verbosity_(verbosity),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      last_print_(start_),
      last_event_(start_) {}

Progress::~Progress() { finish(); }

void Progress::update(double share, const std::string& detail) {
    if (ended_) return;
    const auto now = std::chrono::steady_clock::now();
    const bool tells = seconds_between(last_event_, now) >= shortest_interval;
    const bool prints =
        verbosity_ != Verbosity::quiet && seconds_between(last_print_, now) >= (terminal_ ? shortest_interval : log_interval);
    if (!tells && !prints) return;
    share = std::clamp(share, 0.0, 1.0);
    const double elapsed = seconds_between(start_, now);
    const std::string left = share > 0.005 ? clock_text(elapsed / share * (1 - share)) : std::string("?");
    const std::string state = fmt::format("{}, at most {} left", detail, left);
    if (tells) {
        last_event_ = now;
        tell_progress(label_, share, state);
    }
    if (!prints) return;
    last_print_ = now;
    if (terminal_) {
        const auto filled = static_cast<std::size_t>(share * bar_width);
        const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
        show(fmt::format("\r\033[K{} [{}] {:3.0f} %, {}", label_, bar, 100 * share, state));
        open_ = true;
    } else {
        show(fmt::format("{}: {:.0f} %, {}\n", label_, 100 * share, state));
    }
}

void Progress::finish() {
    if (open_) show("\r\033[K");
    open_ = false;
    ended_ = true;
}

}  // namespace graincrack
