// A half-open range of indices.
#pragma once

#include <cstdint>

namespace graincrack {

struct Range {
    std::int32_t begin = 0;
    std::int32_t end = 0;
    [[nodiscard]] std::int32_t size() const { return end - begin; }
};

}  // namespace graincrack
