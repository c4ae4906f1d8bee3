// Comparison with a tolerance that has a scale: |value − expected| ≤ relative_tolerance · scale. A failure names the caller's
// line; the builtins replace std::source_location, which clang 14 lacks.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace graincrack::test {

/// Fails at the caller's line, with all the numbers, unless the value lies within tolerance; NaN fails.
/// \param scale the physical size against which an error counts: a stress, a length, an energy
inline void expect_close(double value, double expected, double relative_tolerance, double scale, const std::string& what = "",
                         const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const double error = std::abs(value - expected);
    if (!(error <= relative_tolerance * std::abs(scale))) {
        ADD_FAILURE_AT(file, line) << what << (what.empty() ? "" : ": ") << "value " << value << ", expected " << expected
                                   << ": off by " << error << " = " << error / std::abs(scale) << " of the scale " << scale
                                   << ", tolerance " << relative_tolerance;
    }
}

/// Fails unless `act` throws an `Exception` whose message is one line that holds every one of `parts`.
template <class Exception, class Act>
void expect_one_line(Act&& act, const std::vector<std::string>& parts, const char* file = __builtin_FILE(),
                     int line = __builtin_LINE()) {
    const auto fail = [file, line](const std::string& why) { ADD_FAILURE_AT(file, line) << why; };
    try {
        act();
    } catch (const Exception& error) {
        const std::string message = error.what();
        if (message.find('\n') != std::string::npos || message.empty() || message.back() == '.') {
            fail("not one line without a full stop: " + message);
        }
        for (const std::string& part : parts) {
            if (message.find(part) == std::string::npos) fail("no \"" + part + "\" in: " + message);
        }
        return;
    } catch (const std::exception& error) {
        fail(std::string("another exception: ") + error.what());
        return;
    }
    fail("nothing was thrown");
}

}  // namespace graincrack::test
