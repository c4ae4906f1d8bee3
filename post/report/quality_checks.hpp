// The trust block of a report: what a reader needs to know before believing a strength.
#pragma once

#include <string>
#include <vector>

#include "post/report/test_report.hpp"

namespace graincrack {

/// Checks of each run side by side, of many runs by test with the range over its seeds, and in words what holds for all.
std::string trust_block(const std::vector<TestReport>& tests);

}  // namespace graincrack
