#include "share/base/events.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {
namespace {

using Json = nlohmann::ordered_json;

/// The target of this process's events, and its last event, which is collected until the end.
struct Events {
    int file = -1;
    bool are_left = false;  ///< left to another process
    Json outcome{{"event", "outcome"}, {"exit_code", 0}, {"error", ""}, {"outputs", Json::array()}};
};
Events& events() {
    static Events own;
    return own;
}

/// True if the other end of a pipe or socket is closed.
bool has_no_reader(int file) {
    pollfd state{file, 0, 0};
    return ::poll(&state, 1, 0) > 0 && (state.revents & (POLLERR | POLLHUP)) != 0;
}

void write_event(const Json& event) {
    int& file = events().file;
    if (file < 0) return;
    const std::string line = event.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
    for (std::string_view rest = line; !rest.empty();) {
        const bool is_left_alone = has_no_reader(file);
        const ssize_t n = is_left_alone ? -1 : ::write(file, rest.data(), rest.size());
        if (n >= 0) {
            rest.remove_prefix(static_cast<std::size_t>(n));
        } else if (is_left_alone || errno != EINTR) {
            file = -1;
            if (is_left_alone) std::raise(SIGHUP);
            return;
        }
    }
}

/// Reads the number of a descriptor. \throws UsageError if it is not one
int descriptor_of(const std::string& number) {
    int file = -1;
    std::from_chars(number.data(), number.data() + number.size(), file);
    const int flags = ::fcntl(file, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) {
        throw UsageError(fmt::format("--events: descriptor {} is not open for writing; give one that is, or a file", number));
    }
    if (file > STDERR_FILENO) ::fcntl(file, F_SETFD, FD_CLOEXEC);
    return file;
}

}  // namespace

std::ostream& diagnostics(Verbosity verbosity) {
    static std::ostream nowhere(nullptr);
    return verbosity == Verbosity::quiet ? nowhere : std::cerr;
}

void open_events(const std::string& target) {
    if (events().are_left) return;
    const bool is_number =
        !target.empty() && std::all_of(target.begin(), target.end(), [](char c) { return c >= '0' && c <= '9'; });
    const int file = is_number ? descriptor_of(target) : ::open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) throw OutputError(fmt::format("--events {}: cannot be written: {}", target, std::strerror(errno)));
    events().file = file;
}

void leave_events() { events().are_left = true; }

void say(std::ostream& out, const std::string& line) {
    out << line << '\n';
    write_event({{"event", "note"}, {"text", line}});
}

void warn(std::ostream& out, const std::string& subject, const Remark& warning, const std::string& file) {
    out << fmt::format("{}: warning: {}\n", subject, printable(warning.text));
    write_event({{"event", "warning"}, {"code", warning.code}, {"subject", subject}, {"text", warning.text}, {"file", file}});
}

void tell_progress(const std::string& label, double fraction, const std::string& text) {
    write_event({{"event", "progress"}, {"label", label}, {"fraction", fraction}, {"text", text}});
}

void add_to_outcome(const std::string& name, double value) { events().outcome[name] = value; }
void add_to_outcome(const std::string& name, const std::string& value) { events().outcome[name] = value; }
void add_output_to_outcome(const std::string& path) { events().outcome["outputs"].push_back(path); }

void end_events(int exit_code, const std::string& error) {
    events().outcome["exit_code"] = exit_code;
    events().outcome["error"] = error;
    write_event(events().outcome);
}

}  // namespace graincrack
