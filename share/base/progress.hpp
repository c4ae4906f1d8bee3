// Shows the progress of a long computation: a bar if stderr is a terminal, otherwise a line every half minute; and events.
#pragma once

#include <chrono>
#include <string>

#include "share/base/events.hpp"

namespace graincrack {

/// Shows the completed fraction of the work and an upper estimate of the remaining time, also as events. Silent when quiet.
class Progress {
public:
    /// \param label name of the work, e.g. "uniaxial"
    Progress(std::string label, Verbosity verbosity);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// \param share completed fraction of the work, 0 to 1
    /// \param detail short text shown behind the bar, e.g. "stress 54.2 MPa, 12 cracks"
    void update(double share, const std::string& detail);
    /// Ends the bar; later updates print nothing.
    void finish();

private:
    std::string label_;
    Verbosity verbosity_;
    bool terminal_;
    bool open_ = false;
    bool ended_ = false;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point last_print_;
    std::chrono::steady_clock::time_point last_event_;
};

}  // namespace graincrack
