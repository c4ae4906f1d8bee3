// Cases with known answers: measured beside expected values. A test compares as usual and prints a row.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace graincrack::test {

/// Fails at the caller's line unless |measured − expected| ≤ tolerance · scale; NaN fails. Either way the comparison is a row
/// of the table that is printed when the test ends and that `tests/run --all` gathers (through the folder named by
/// $GRAINCRACK_VERIFICATION). Comparisons of one test under one name share a row: the worst of them, and their number.
///
/// \param name "section: case (unit)"; sections: law, elements, dynamics, specimens, phases, calibration
/// \param tolerance relative to the scale
/// \param source where the expected value comes from
/// \param scale the magnitude to which an error is relative; 0: the expected value. Where 0 is expected, the row shows the
///        measured value over the scale.
void verify(const std::string& name, double measured, double expected, double tolerance, const std::string& source,
            double scale = 0, const char* file = __builtin_FILE(), int line = __builtin_LINE());

/// The same for a bound: fails unless low ≤ measured ≤ high.
void verify_between(const std::string& name, double measured, double low, double high, const std::string& source,
                    const char* file = __builtin_FILE(), int line = __builtin_LINE());

/// Writes columns of one length to NAME.csv in the folder named by $GRAINCRACK_VERIFICATION, for the figures of the pages
/// of share/studies/known-answers; nothing where the variable is not set.
void record_curves(const std::string& name, const std::vector<std::pair<std::string, std::vector<double>>>& columns);

}  // namespace graincrack::test
