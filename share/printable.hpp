// Texts that come from outside, as they are shown: a terminal, a table or a page must not obey them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace graincrack {

/// The text with its control characters as `\x1b` and the like, those beyond ASCII (U+0080 to U+009F) too.
inline std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
        const bool is_beyond_ascii = byte == 0xc2 && next >= 0x80 && next <= 0x9f;
        if (byte < 0x20 || byte == 0x7f || is_beyond_ascii) {
            shown += fmt::format("\\x{:02x}", is_beyond_ascii ? next : byte);
            i += is_beyond_ascii ? 1 : 0;
        } else {
            shown += text[i];
        }
    }
    return shown;
}

}  // namespace graincrack
