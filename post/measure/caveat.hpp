// A caveat: a reason to doubt the strength of a test.
#pragma once

#include <string>

namespace graincrack {

struct Caveat {
    std::string kind;  ///< without numbers, so that the runs that have it can be counted: "first cracks outside 0.5 R"
    std::string text;  ///< with them: "first cracks at 0.81 R, not inside 0.5 R"
};

}  // namespace graincrack
