// Keeps two programs from writing the same output at once.
#pragma once

#include <string>

namespace graincrack {

/// Holds the file `output`.lock while it lives, then removes it. The system releases the lock of a program that has died; what is
/// left of its file does not matter. Where the file cannot be made or locked, as on a file system without locks, there is none.
class OutputLock {
public:
    /// \throws OutputError if another program holds it
    explicit OutputLock(const std::string& output);
    ~OutputLock();
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;

private:
    std::string path_;
    int file_ = -1;
};

}  // namespace graincrack
