// Arrays of numbers as a page holds them: reals in steps of 16 bits; whole numbers deflated, as letters.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace graincrack {

/// Reals as whole numbers of steps above the least of them. None is off by more than half a step.
struct QuantisedArray {
    double low = 0;
    double step = 0;                  ///< the range over 65535; 0 where all values are equal
    std::vector<std::int32_t> steps;  ///< 0 to 65535
};
/// \param values of any unit, which `low` and `step` then have; one that is not finite becomes the least
QuantisedArray quantised(const std::vector<double>& values);

/// Differences of successive numbers, the first from 0, by magnitude (0, −1, 1, −2, …), in four planes of bytes, the lowest
/// first, deflated (RFC 1950), in base64. \throws OutputError without memory
std::string packed(const std::vector<std::int32_t>& values);

}  // namespace graincrack
