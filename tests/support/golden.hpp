// Texts that tests compare with golden files: reports, tables, pictures as text, messages. `tests/run --accept` writes them anew.
#pragma once

#include <string>

#include "tests/support/check.hpp"

namespace graincrack::test {

/// Fails at the caller's line, with the first line that differs, unless `text` is that of the caller's golden file: x_test.golden
/// beside x_test.cpp, in the section "Suite.Test" of the test that runs, or "Suite.Test: what". Line ends at the end of a text
/// do not count, and FOLDER and SOURCE stand for a temporary folder and the folder of the sources. With GRAINCRACK_ACCEPT=1 in
/// the environment the section is written instead. \param what tells several texts of one test apart
void expect_golden(const std::string& text, const std::string& what = "", const char* file = __builtin_FILE(),
                   int line = __builtin_LINE());

/// Messages of what must be refused, a line each, for one golden text of a test.
class Refusals {
public:
    /// Adds "case: message" for what `act` throws; fails at the caller's line unless it is an `Exception` of one line.
    template <class Exception, class Act>
    void add(const std::string& what, Act&& act, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        expect_one_line<Exception>(
            [&] {
                try {
                    act();
                } catch (const std::exception& error) {
                    text_ += what + ": " + error.what() + "\n";
                    throw;
                }
            },
            {}, file, line);
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

}  // namespace graincrack::test
