#include "post/ccd/assignment.hpp"

#include <charconv>
#include <cmath>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::ccd {

Assignment parse_assignment(const std::string& text, const std::string& option, const std::string& form) {
    const auto refuse = [&] { throw UsageError(option + " " + text + ": " + form + " is needed"); };
    const auto [name, numbers] = key_and_value(text, option, form);
    Assignment out{name, {}};
    for (const std::string_view number : split(numbers, ':')) {
        double value = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
        if (error != std::errc{} || end != number.data() + number.size() || !std::isfinite(value)) refuse();
        out.values.push_back(value);
    }
    return out;
}

}  // namespace graincrack::ccd
