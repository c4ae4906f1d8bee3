// The quality checks of a report: whether the strengths of its runs can be relied on.
#pragma once

#include <string>
#include <vector>

#include "post/report/test_report.hpp"

namespace graincrack {

/// Checks of each run side by side, of many runs by test with the range over its seeds, and what holds for all as text.
std::string quality_checks(const std::vector<TestReport>& tests);

}  // namespace graincrack
