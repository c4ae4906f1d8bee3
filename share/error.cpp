#include "share/error.hpp"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace graincrack {
namespace {

volatile std::sig_atomic_t caught_signal = 0;

void remember_signal(int signal) { caught_signal = signal; }

int report(const std::string& tool, const std::string& message, ExitCode code) {
    std::string line = tool + ": " + message;
    for (char& c : line) {
        if (c == '\n') {
            c = ' ';
        }
    }
    std::fprintf(stderr, "%s\n", line.c_str());
    return static_cast<int>(code);
}

}  // namespace

int run_tool(const std::string& tool, const std::function<int()>& body) {
    std::signal(SIGPIPE, SIG_DFL);  // a reader that closes the pipe ends the tool without a message
    try {
        return body();
    } catch (const Interrupted& stopped) {
        std::fprintf(stderr, "%s: stopped by signal %d\n", tool.c_str(), stopped.signal());
        return 128 + stopped.signal();
    } catch (const Error& error) {
        return report(tool, error.what(), error.code());
    } catch (const std::bad_alloc&) {
        return report(tool, "out of memory: a smaller specimen or fewer frames would fit", ExitCode::internal);
    } catch (const std::exception& error) {
        return report(tool, std::string("internal error: ") + error.what(), ExitCode::internal);
    }
}

void catch_stop_signals() {
    std::signal(SIGINT, remember_signal);
    std::signal(SIGTERM, remember_signal);
}

int stop_signal() noexcept { return caught_signal; }

void throw_if_interrupted() {
    if (caught_signal != 0) {
        throw Interrupted(caught_signal);
    }
}

}  // namespace graincrack
