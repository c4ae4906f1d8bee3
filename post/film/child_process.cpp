#include "post/film/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include "share/base/error.hpp"

namespace graincrack {

namespace {

[[noreturn]] void fail(const std::string& program, const std::string& what, int cause) {
    throw OutputError(fmt::format("{}: {}: {}", program, what, std::generic_category().message(cause)));
}

/// What a child begins with: stdin, stdout and stderr, signals as usual, a process group of its own.
class Start {
public:
    Start(int input, int output, int errors) {
        posix_spawn_file_actions_init(&files_);
        posix_spawn_file_actions_adddup2(&files_, input, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&files_, errors, STDERR_FILENO);
        posix_spawnattr_init(&attributes_);
        sigset_t usual;
        sigemptyset(&usual);
        sigaddset(&usual, SIGPIPE);
        posix_spawnattr_setsigdefault(&attributes_, &usual);
        posix_spawnattr_setpgroup(&attributes_, 0);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    ~Start() {
        posix_spawn_file_actions_destroy(&files_);
        posix_spawnattr_destroy(&attributes_);
    }
    Start(const Start&) = delete;
    Start& operator=(const Start&) = delete;
    /// \return 0 or the cause
    int run(pid_t& process, std::vector<char*>& words) {
        return posix_spawnp(&process, words.front(), &files_, &attributes_, words.data(), environ);
    }

private:
    posix_spawn_file_actions_t files_{};
    posix_spawnattr_t attributes_{};
};

}  // namespace

ChildProcess::ChildProcess() : pipe_handler_(std::signal(SIGPIPE, SIG_IGN)) {}

std::unique_ptr<ChildProcess> ChildProcess::start(std::vector<std::string> words) {
    std::unique_ptr<ChildProcess> child(new ChildProcess);
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail(words.front(), "cannot be started", errno);
    child->input_ = pipe[1];
    child->output_ = ::memfd_create("output", MFD_CLOEXEC);
    child->errors_ = ::memfd_create("errors", MFD_CLOEXEC);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const int cause = Start(pipe[0], child->output_, child->errors_).run(child->process_, pointers);
    ::close(pipe[0]);
    if (cause == ENOENT || cause == EACCES) return nullptr;
    if (cause != 0) fail(words.front(), "cannot be started", cause);
    return child;
}

ChildProcess::~ChildProcess() {
    close_input();
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        static_cast<void>(wait());
    }
    for (const int file : {output_, errors_}) {
        if (file >= 0) ::close(file);
    }
    std::signal(SIGPIPE, pipe_handler_);
}

void ChildProcess::close_input() {
    if (input_ >= 0) ::close(std::exchange(input_, -1));
}

bool ChildProcess::write(std::span<const unsigned char> bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(input_, bytes.data(), bytes.size());
        if (n >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(n));
        } else if (errno == EPIPE) {
            return false;
        } else if (errno != EINTR) {
            fail("pipe", "cannot be written", errno);
        }
    }
    return true;
}

int ChildProcess::wait() {
    close_input();
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) throw_if_interrupted();
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string ChildProcess::content_of(int file) {
    std::string text;
    std::array<char, 4096> part{};
    for (off_t at = 0;;) {
        const ssize_t n = ::pread(file, part.data(), part.size(), at);
        if (n <= 0) return text;
        text.append(part.data(), static_cast<std::size_t>(n));
        at += n;
    }
}

}  // namespace graincrack
