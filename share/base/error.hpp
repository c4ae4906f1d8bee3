// Errors of the three tools: an exception type for each cause, one line for each message, an exit code for each type.
//
// Exceptions are thrown outside hot loops and caught only in `run_tool`. A message names the file or option, says what
// is wrong and what would be right; it has no trailing full stop and no line break.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace graincrack {

/// Exit codes of all tools; a run stopped by signal n ends with 128 + n.
enum class ExitCode { done = 0, internal = 1, usage = 2, input = 3, numerical = 4, output = 5 };

/// Base of all errors a user can meet.
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
/// The run was stopped by a signal (exit 128 + signal).
class Interrupted : public std::runtime_error {
public:
    explicit Interrupted(int signal) : std::runtime_error("stopped by a signal"), signal_(signal) {}
    [[nodiscard]] int signal() const noexcept { return signal_; }

private:
    int signal_;
};

/// Runs the body of a tool's main and turns what it throws into one line on stderr, `tool: message`, and an exit code; with the
/// last of its events.
int run_tool(const std::string& tool, const std::function<int()>& body);

/// Catches SIGINT, SIGTERM, SIGHUP, and SIGXCPU and SIGUSR2, by which schedulers warn, from here on, so that work ends at the
/// next safe point.
/// \param patience s after which the tool ends wherever it is, without what `hold_output` names; 0: it is waited for
void catch_stop_signals(unsigned patience = 0);
/// Names the output whose unfinished file and lock, PATH.part and PATH.lock, are removed where a tool ends at once; "" for none.
void hold_output(const std::string& path);
/// The signal that asked to stop, or 0.
int stop_signal() noexcept;
/// Throws `Interrupted` if a signal asked to stop.
void throw_if_interrupted();

}  // namespace graincrack
