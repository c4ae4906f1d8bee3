// Writes the quality checks of a report, which tell whether the strengths of its runs are reliable.
#pragma once

#include <string>
#include <vector>

#include "post/report/test_report.hpp"

namespace graincrack {

/// Returns a table with the checks of each run side by side or, for many runs, of each test with the range over its seeds. Checks
/// with one result for all runs are text.
std::string quality_checks(const std::vector<TestReport>& tests);

}  // namespace graincrack
