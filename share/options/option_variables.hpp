// The environment variables of options, GRAINCRACK_<OPTION>, of all three tools: one that is misspelt is told instead of passed
// over.
#pragma once

#include <string>
#include <vector>

namespace graincrack {

/// The options of the three tools that a variable can give, without dashes in front, and `materials`, the folder of materials. A
/// variable may be meant for another tool than the one that runs.
const std::vector<std::string>& options_of_all_tools();

/// "GRAINCRACK_MAX_STRAIN" for "max-strain".
std::string variable_of(const std::string& option);

/// A sentence for each variable of the environment that is no option of any tool but nearly one, in alphabetical order.
std::vector<std::string> misspelt_variables();

}  // namespace graincrack
