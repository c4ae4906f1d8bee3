// Progress of a long computation: on stderr a bar on a terminal, otherwise a line every half minute; events.
#pragma once

#include <chrono>
#include <string>

#include "share/base/events.hpp"

namespace graincrack {

/// Shows the completed share of the work and an upper estimate of the time left, as events too. Prints nothing when quiet.
class Progress {
public:
    /// \param label what is being done, e.g. "uniaxial"
    Progress(std::string label, Verbosity verbosity);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// \param share work done, 0 to 1
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
