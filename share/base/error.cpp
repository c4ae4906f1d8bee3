#include "share/base/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>

#include "share/base/events.hpp"
#include "share/base/text.hpp"

namespace graincrack {
namespace {

volatile std::sig_atomic_t caught_signal = 0;
unsigned patience = 0;                             // s, set by `catch_stop_signals`
const char* name_of_tool = "";                     // set by `run_tool`
std::array<std::array<char, 5000>, 2> unfinished;  // paths set by `hold_output`

/// Ends a program that has not reached a safe point, with the message of `run_tool`. It calls async-signal-safe functions only.
void end_at_once(int /*alarm*/) {
    for (const auto& path : unfinished) ::unlink(path.data());
    const std::array<char, 3> number{static_cast<char>('0' + caught_signal / 10), static_cast<char>('0' + caught_signal % 10),
                                     '\n'};
    const std::string_view digits(number.data() + (caught_signal < 10 ? 1 : 0), caught_signal < 10 ? 2 : 3);
    for (const std::string_view part : {std::string_view(name_of_tool), std::string_view(": stopped by signal "), digits}) {
        static_cast<void>(!::write(STDERR_FILENO, part.data(), part.size()));
    }
    ::_exit(128 + caught_signal);
}

/// The second signal ends the program at once. Three cases are exceptions: a signal that comes with the first (`timeout` sends
/// each to its command and to the command's group), SIGHUP, which both the shell and the system send when a terminal is closed,
/// and SIGXCPU, which comes every second.
void remember_signal(int signal) {
    static std::time_t first;
    const std::time_t now = std::time(nullptr);
    if (caught_signal != 0 && now > first + 1 && signal != SIGHUP && signal != SIGXCPU) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    if (caught_signal != 0) return;
    caught_signal = signal;
    first = now;
    if (patience > 0) ::alarm(patience);
}

constexpr std::size_t longest_message = 1500;  // bytes; a list of all columns of a table has about a thousand

int report(const std::string& tool, const std::string& message, int code) {
    std::string line = message;
    for (char& c : line) {
        if (c == '\n') c = ' ';
    }
    line = tool + ": " + shortened(printable(line), longest_message);
    std::fprintf(stderr, "%s\n", line.c_str());
    end_events(code, line);
    return code;
}

/// Opens those of stdin, stdout and stderr that the caller has closed, so that no other file takes their numbers; using the first
/// two fails.
void open_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0) static_cast<void>(::open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY));
    }
}

/// Writes the buffered output. \throws OutputError if a part of it cannot be written
void flush_stdout() {
    errno = 0;
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw OutputError(std::string("stdout: could not be written whole") + (errno != 0 ? ": " : "") +
                          (errno != 0 ? std::strerror(errno) : ""));
    }
}

}  // namespace

int run_tool(const std::string& tool, const std::function<int()>& body) {
    constexpr int internal = static_cast<int>(ExitCode::internal);
    name_of_tool = tool.c_str();
    open_closed_streams();
    std::signal(SIGPIPE, SIG_DFL);  // a reader that closes the pipe ends the tool without a message
    std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit fails as on a full disk
    try {
        const int code = body();
        flush_stdout();
        end_events(code, "");
        return code;
    } catch (const Interrupted& stopped) {
        return report(tool, "stopped by signal " + std::to_string(stopped.signal()), 128 + stopped.signal());
    } catch (const Error& error) {
        return report(tool, error.what(), static_cast<int>(error.code()));
    } catch (const std::bad_alloc&) {
        return report(tool, "out of memory: use a smaller specimen or fewer frames", internal);
    } catch (const std::exception& error) {
        return report(tool, std::string("internal error: ") + error.what(), internal);
    }
}

void catch_stop_signals(unsigned patience_) {
    patience = patience_;
    std::signal(SIGALRM, end_at_once);
    for (const int signal : {SIGINT, SIGTERM, SIGXCPU, SIGUSR2}) std::signal(signal, remember_signal);
    if (std::signal(SIGHUP, remember_signal) == SIG_IGN) {
        std::signal(SIGHUP, SIG_IGN);  // set by nohup
    }
}

void hold_output(const std::string& path) {
    const std::array endings{".part", ".lock"};
    for (std::size_t i = 0; i < unfinished.size(); ++i) {
        const std::string name = path.empty() ? "" : path + endings[i];
        unfinished[i].fill(0);
        if (name.size() < unfinished[i].size()) std::copy(name.begin(), name.end(), unfinished[i].begin());
    }
}

int stop_signal() noexcept { return caught_signal; }

void throw_if_interrupted() {
    if (caught_signal != 0) throw Interrupted(caught_signal);
}

}  // namespace graincrack
