// Progress prints little where stderr is no terminal, and never writes to stdout.
#include "share/base/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace graincrack {
namespace {

// Under ctest stderr is no terminal: a line every half minute, so a short piece of work prints none.
TEST(Progress, OfShortWorkPrintsNothingWithoutATerminal) {
    for (const Verbosity verbosity : {Verbosity::quiet, Verbosity::normal, Verbosity::verbose}) {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        {
            Progress progress("uniaxial", verbosity);
            for (int i = 0; i <= 100; ++i) progress.update(0.01 * i, "stress 1 MPa");
            progress.finish();
            progress.update(1, "after the end");
        }
        EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    }
}

TEST(Progress, IsABarOnATerminalThatIsWipedAtTheEnd) {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(master, 0);
    ASSERT_EQ(::grantpt(master), 0);
    ASSERT_EQ(::unlockpt(master), 0);
    const int terminal = ::open(::ptsname(master), O_RDWR | O_NOCTTY);
    ASSERT_GE(terminal, 0);
    const int saved = ::dup(STDERR_FILENO);
    ::dup2(terminal, STDERR_FILENO);
    {
        Progress progress("uniaxial", Verbosity::normal);
        std::this_thread::sleep_for(std::chrono::milliseconds(250));  // it prints five times a second
        progress.update(0.5, "stress 54.2 MPa");
    }
    ::dup2(saved, STDERR_FILENO);
    ::close(saved);
    // What two writes have put into a terminal may come in two reads.
    std::string text;
    pollfd readable{master, POLLIN, 0};
    while (!text.ends_with("\r\033[K") && ::poll(&readable, 1, 2000) > 0) {
        char bytes[512];
        const ssize_t n = ::read(master, bytes, sizeof bytes);
        ASSERT_GT(n, 0);
        text.append(bytes, static_cast<std::size_t>(n));
    }
    ::close(terminal);
    ::close(master);
    EXPECT_NE(text.find("uniaxial [############............]  50 %, stress 54.2 MPa"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("\r\033[K")) << text;
}

}  // namespace
}  // namespace graincrack
