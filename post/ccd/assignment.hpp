// Options of the form NAME=NUMBER:NUMBER….
#pragma once

#include <string>
#include <vector>

namespace graincrack::ccd {

struct Assignment {
    std::string name;
    std::vector<double> values;
};
/// \throws UsageError naming `option` and the `form` that would be right
Assignment parse_assignment(const std::string& text, const std::string& option, const std::string& form);

}  // namespace graincrack::ccd
