// Every error ends with one line and an exit code.
#include "share/base/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <new>

#include "share/base/text.hpp"
#include "tests/support/golden.hpp"

namespace graincrack {
namespace {

/// What a program that ends with an exception returns and prints.
template <class Exception>
std::string outcome_of(const Exception& exception) {
    testing::internal::CaptureStderr();
    const int code = run_tool("graincrack-test", [&]() -> int { throw exception; });
    return fmt::format("{} {}", code, testing::internal::GetCapturedStderr());
}

TEST(Error, EndsWithItsCodeAndOneLineWithTheNameOfTheTool) {
    EXPECT_EQ(run_tool("graincrack-test", [] { return 7; }), 7);
    test::expect_golden(outcome_of(std::runtime_error("x")) + outcome_of(UsageError("--edge: no number")) +
                        outcome_of(InputError("a\nb\nc")) + outcome_of(NumericalError("x")) + outcome_of(OutputError("x")) +
                        outcome_of(Interrupted(SIGINT)) + outcome_of(Interrupted(SIGTERM)) + outcome_of(std::logic_error("x")) +
                        outcome_of(std::bad_alloc()));
}

TEST(Printable, ShowsWhatATerminalWouldObey) {
    EXPECT_EQ(printable("a\x1b[2J\x7f\xc2\x9b"), "a\\x1b[2J\\x7f\\x9b");
    EXPECT_EQ(printable("gnp\u202e\u2066\u061c\u200f\u2028.h5"), "gnp\\u202e\\u2066\\u061c\\u200f\\u2028.h5");
    EXPECT_EQ(printable("µ 10 °… „Granit“ ست"), "µ 10 °… „Granit“ ست");
    EXPECT_EQ(printable(std::string("\0", 1)), "\\x00");
}

TEST(Shortened, KeepsBeginAndEndOfALongMessage) {
    EXPECT_EQ(shortened("short", 30), "short");
    EXPECT_EQ(shortened(std::string(50, 'a') + std::string(50, 'b'), 30), "aaaaaaaaaaaaaaaaaaaa … bbbbbbbbbb");
    EXPECT_EQ(shortened("aµµµµµµ", 6), "aµ … µ");  // between whole characters
    const std::string line = outcome_of(InputError(std::string(400000, 'x') + "; end"));
    EXPECT_LT(line.size(), 1600U);
    EXPECT_TRUE(line.ends_with("; end\n")) << line;
}

// In a process of its own, since the signal handler stays installed for the rest of the process.
TEST(ErrorDeathTest, OfAStopSignalIsThrownAtASafePoint) {
    EXPECT_EXIT(
        {
            catch_stop_signals();
            const bool quiet = stop_signal() == 0;
            std::raise(SIGTERM);
            const int code = run_tool("tool", []() -> int {
                throw_if_interrupted();
                return 0;
            });
            std::_Exit(quiet ? code : 99);
        },
        testing::ExitedWithCode(143), "signal 15");
}

TEST(Error, IsNotThrownWithoutASignal) { EXPECT_NO_THROW(throw_if_interrupted()); }

}  // namespace
}  // namespace graincrack
