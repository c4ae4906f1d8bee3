// Packs arrays of numbers for a page: reals in steps of 16 bits, whole numbers deflated and as base64.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace graincrack {

/// Reals as whole numbers of steps above the smallest. No value is off by more than half a step.
struct QuantisedArray {
    double low = 0;
    double step = 0;                  ///< the range over 65535; 0 if all values are equal
    std::vector<std::int32_t> steps;  ///< 0 to 65535
};
/// Quantises values. \param values of any unit, which is also that of `low` and `step`; values that are not finite become `low`
QuantisedArray quantised(const std::vector<double>& values);

/// Packs numbers: differences of successive numbers, the first from 0, are numbered by magnitude (0, −1, 1, −2, …), split into
/// four planes of bytes with the lowest first, deflated (RFC 1950) and encoded as base64. \throws OutputError without memory
std::string packed(const std::vector<std::int32_t>& values);

}  // namespace graincrack
