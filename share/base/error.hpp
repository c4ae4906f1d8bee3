// Errors of the three programs. Each cause has an exception type, each message one line, and each type an exit code.
//
// Exceptions are thrown outside hot loops and caught in `run_tool` only. A message names the file or option, the error and what
// would be right. It has no full stop at the end and no line break.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace graincrack {

/// Exit codes of all programs. A program stopped by signal n exits with 128 + n.
enum class ExitCode { done = 0, internal = 1, usage = 2, input = 3, numerical = 4, output = 5 };

/// Base of all errors that a user can cause.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ExitCode code() const noexcept { return code_; }

private:
    ExitCode code_;
};

/// A wrong option, configuration key or combination of them (exit 2).
struct UsageError : Error {
    explicit UsageError(const std::string& message) : Error(ExitCode::usage, message) {}
};
/// An input file that is missing, damaged, foreign, or whose data cannot be used (exit 3).
struct InputError : Error {
    explicit InputError(const std::string& message) : Error(ExitCode::input, message) {}
};
/// A computation that became unstable or found no equilibrium (exit 4).
struct NumericalError : Error {
    explicit NumericalError(const std::string& message) : Error(ExitCode::numerical, message) {}
};
/// Output that could not be written whole (exit 5).
struct OutputError : Error {
    explicit OutputError(const std::string& message) : Error(ExitCode::output, message) {}
};
/// A signal stopped the run (exit 128 + signal).
class Interrupted : public std::runtime_error {
public:
    explicit Interrupted(int signal) : std::runtime_error("stopped by a signal"), signal_(signal) {}
    [[nodiscard]] int signal() const noexcept { return signal_; }

private:
    int signal_;
};

/// Runs the body of main. It turns an exception into one line on stderr, `tool: message`, the last event and an exit code.
int run_tool(const std::string& tool, const std::function<int()>& body);

/// Catches SIGINT, SIGTERM, SIGHUP and the warnings of schedulers, SIGXCPU and SIGUSR2, so that work ends at the next safe point.
/// \param patience time after which the program ends in any state and removes the files of `hold_output`, s; 0: unlimited
/// \param patience s after which the tool ends wherever it is, without what `hold_output` names; 0: it is waited for
void catch_stop_signals(unsigned patience = 0);
/// Names the output whose unfinished file PATH.part and lock PATH.lock are removed when a program ends at once; "" for none.
void hold_output(const std::string& path);
/// The signal that requested a stop, or 0.
int stop_signal() noexcept;
/// Throws `Interrupted` if a signal requested a stop.
void throw_if_interrupted();

}  // namespace graincrack
