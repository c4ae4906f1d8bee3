// A program that runs beside this one.
#pragma once

#include <sys/types.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace graincrack {

/// A program, without a shell, in a process group of its own, so that Ctrl-C in a terminal reaches this program alone. It takes
/// bytes on its stdin; what it prints is kept. While it lives, a pipe that it has closed is an error of `write` and no signal.
class ChildProcess {
public:
    /// \param words the name of the program, which is looked for on the PATH, and its arguments
    /// \return null if there is no such program \throws OutputError if it cannot be started
    static std::unique_ptr<ChildProcess> start(std::vector<std::string> words);
    /// Ends the program if it still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// \return false if the program takes no more \throws OutputError
    bool write(std::span<const unsigned char> bytes);
    /// Closes its stdin and waits for its end. \return its exit code, 128 + n if signal n has ended it
    int wait();
    /// What it has printed on stdout and on stderr.
    [[nodiscard]] std::string output() const { return content_of(output_); }
    [[nodiscard]] std::string errors() const { return content_of(errors_); }

private:
    ChildProcess();
    static std::string content_of(int file);
    void close_input();

    pid_t process_ = -1;
    int input_ = -1;
    int output_ = -1;  ///< files in memory: a program never waits for one to be read
    int errors_ = -1;
    void (*pipe_handler_)(int);
};

}  // namespace graincrack
