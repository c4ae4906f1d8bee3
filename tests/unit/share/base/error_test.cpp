// Every error ends with one line and an exit code.
#include "share/base/error.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <new>

#include "share/base/text.hpp"

namespace graincrack {
namespace {

struct Outcome {
    int code;
    std::string text;
};
template <class Body>
Outcome outcome_of(Body&& body) {
    testing::internal::CaptureStderr();
    const int code = run_tool("graincrack-test", body);
    return {code, testing::internal::GetCapturedStderr()};
}
template <class Exception>
Outcome outcome_of_throwing(const Exception& e) {
    return outcome_of([&e]() -> int { throw e; });
}

TEST(Error, CodesOfTheDesign) {
    EXPECT_EQ(outcome_of([] { return 0; }).code, 0);
    EXPECT_EQ(outcome_of([] { return 0; }).text, "");
    EXPECT_EQ(outcome_of([] { return 7; }).code, 7);
    EXPECT_EQ(outcome_of_throwing(std::runtime_error("x")).code, 1);
    EXPECT_EQ(outcome_of_throwing(UsageError("x")).code, 2);
    EXPECT_EQ(outcome_of_throwing(InputError("x")).code, 3);
    EXPECT_EQ(outcome_of_throwing(NumericalError("x")).code, 4);
    EXPECT_EQ(outcome_of_throwing(OutputError("x")).code, 5);
    EXPECT_EQ(outcome_of_throwing(Interrupted(SIGINT)).code, 130);
    EXPECT_EQ(outcome_of_throwing(Interrupted(SIGTERM)).code, 143);
}

TEST(Error, OneLineWithTheToolsName) {
    EXPECT_EQ(outcome_of_throwing(UsageError("--edge: no number")).text, "graincrack-test: --edge: no number\n");
    EXPECT_EQ(outcome_of_throwing(InputError("a\nb\nc")).text, "graincrack-test: a b c\n");
    EXPECT_EQ(outcome_of_throwing(std::logic_error("x")).text, "graincrack-test: internal error: x\n");
    EXPECT_EQ(outcome_of_throwing(Interrupted(SIGTERM)).text, "graincrack-test: stopped by signal 15\n");
    const Outcome memory = outcome_of_throwing(std::bad_alloc());
    EXPECT_EQ(memory.code, 1);
    EXPECT_NE(memory.text.find("out of memory"), std::string::npos);
}

// In a process of its own, since the signal handler stays installed for the rest of the process.
TEST(Error, WhatATerminalWouldObeyIsShown) {
    EXPECT_EQ(printable("a\x1b[2J\x7f\xc2\x9b"), "a\\x1b[2J\\x7f\\x9b");
    EXPECT_EQ(printable("gnp\u202e\u2066\u061c\u200f\u2028.h5"), "gnp\\u202e\\u2066\\u061c\\u200f\\u2028.h5");
    EXPECT_EQ(printable("µ 10 °… „Granit“ ست"), "µ 10 °… „Granit“ ست");
    EXPECT_EQ(printable(std::string("\0", 1)), "\\x00");
}

TEST(Error, LongMessagesAreShortened) {
    EXPECT_EQ(shortened("short", 30), "short");
    EXPECT_EQ(shortened(std::string(50, 'a') + std::string(50, 'b'), 30), "aaaaaaaaaaaaaaaaaaaa … bbbbbbbbbb");
    EXPECT_EQ(shortened("aµµµµµµ", 6), "aµ … µ");  // between whole characters
    testing::internal::CaptureStderr();
    run_tool("tool", []() -> int { throw InputError(std::string(400000, 'x') + "; a short text is needed"); });
    const std::string line = testing::internal::GetCapturedStderr();
    EXPECT_LT(line.size(), 1600U);
    EXPECT_TRUE(line.ends_with("; a short text is needed\n")) << line;
}

TEST(ErrorDeathTest, AStopSignalIsRememberedUntilASafePoint) {
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
        testing::ExitedWithCode(143), "tool: stopped by signal 15");
}

TEST(Error, WithoutASignalWorkGoesOn) { EXPECT_NO_THROW(throw_if_interrupted()); }

}  // namespace
}  // namespace graincrack
