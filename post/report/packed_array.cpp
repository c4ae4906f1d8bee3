#include "post/report/packed_array.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "post/report/html.hpp"
#include "share/base/error.hpp"

namespace graincrack {

QuantisedArray quantised(const std::vector<double>& values) {
    constexpr double most_steps = 65535;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    QuantisedArray array;
    if (low <= high) array = {low, high / most_steps - low / most_steps, {}};
    for (const double value : values) {
        const bool is_above = array.step > 0 && std::isfinite(value);
        const double steps = is_above ? std::round(value / array.step - low / array.step) : 0;
        array.steps.push_back(static_cast<std::int32_t>(std::clamp(steps, 0.0, most_steps)));
    }
    return array;
}

std::string packed(const std::vector<std::int32_t>& values) {
    const std::size_t n = values.size();
    std::vector<unsigned char> planes(4 * n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto difference = static_cast<std::uint32_t>(values[i]) - static_cast<std::uint32_t>(i > 0 ? values[i - 1] : 0);
        const std::uint32_t by_magnitude = (difference << 1U) ^ (difference >> 31U != 0 ? ~0U : 0U);
        for (std::size_t plane = 0; plane < 4; ++plane) {
            planes[plane * n + i] = static_cast<unsigned char>(by_magnitude >> (8 * plane));
        }
    }
    uLongf size = compressBound(planes.size());
    std::vector<unsigned char> deflated(size);
    if (compress2(deflated.data(), &size, planes.data(), planes.size(), 6) != Z_OK) {
        throw OutputError("page: its arrays could not be deflated; more memory is needed");
    }
    deflated.resize(size);
    return html::base64(deflated);
}

}  // namespace graincrack
