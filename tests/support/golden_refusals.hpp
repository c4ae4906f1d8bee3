// Refusals that are compared with a golden text as their test ends.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "tests/support/golden.hpp"

namespace graincrack::test {

/// Refusals of a test: as they end, their messages are compared with its golden text, unless there are none.
class GoldenRefusals : public Refusals {
public:
    /// \param what as of expect_golden
    explicit GoldenRefusals(std::string what = "", const char* file = __builtin_FILE(), int line = __builtin_LINE())
        : what_(std::move(what)), file_(file), line_(line) {}
    ~GoldenRefusals() {
        if (!text().empty() && !testing::Test::HasFatalFailure()) expect_golden(text(), what_, file_, line_);
    }
    GoldenRefusals(const GoldenRefusals&) = delete;
    GoldenRefusals& operator=(const GoldenRefusals&) = delete;

    /// Adds what `act(text)` throws for each of some texts, under that text.
    template <class Exception, class Act>
    void add_each(std::initializer_list<const char*> texts, const Act& act) {
        for (const char* text : texts) add<Exception>(text, [&] { act(text); });
    }

private:
    std::string what_;
    const char* file_;
    int line_;
};

}  // namespace graincrack::test
