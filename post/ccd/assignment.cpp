#include "post/ccd/assignment.hpp"

#include <charconv>
#include <cmath>

#include "share/base/error.hpp"

namespace graincrack::ccd {

Assignment parse_assignment(const std::string& text, const std::string& option, const std::string& form) {
    const auto refuse = [&] { throw UsageError(option + " " + text + ": " + form + " is needed"); };
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos || sign == 0) refuse();
    Assignment out{text.substr(0, sign), {}};
    for (const char* from = text.data() + sign + 1; true; ++from) {
        double value = 0;
        const auto [end, error] = std::from_chars(from, text.data() + text.size(), value);
        if (error != std::errc{} || !std::isfinite(value)) refuse();
        out.values.push_back(value);
        if (end == text.data() + text.size()) return out;
        if (*end != ':') refuse();
        from = end;
    }
}

}  // namespace graincrack::ccd
