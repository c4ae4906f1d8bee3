// Texts that come from outside, as they are shown: a terminal, a table or a page must not obey them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace graincrack {

/// Length in bytes of the character at a place of a UTF-8 text that a terminal would obey, 0 of one that it shows: control
/// characters, also those beyond ASCII (U+0080 to U+009F), line separators and those that turn the direction of writing.
inline std::size_t length_of_control(std::string_view text) {
    const auto is_between = [text](std::string_view prefix, unsigned char first, unsigned char last) {
        const std::size_t n = prefix.size();
        return text.size() > n && text.substr(0, n) == prefix && static_cast<unsigned char>(text[n]) >= first &&
               static_cast<unsigned char>(text[n]) <= last;
    };
    if (is_between("", 0x00, 0x1f) || is_between("", 0x7f, 0x7f)) return 1;
    if (is_between("\xc2", 0x80, 0x9f) || is_between("\xd8", 0x9c, 0x9c)) return 2;                 // U+061C
    const bool turns = is_between("\xe2\x80", 0x8e, 0x8f) || is_between("\xe2\x80", 0xa8, 0xae) ||  // U+200E, F; U+2028 to E
                       is_between("\xe2\x81", 0xa6, 0xa9);                                          // U+2066 to 9
    return turns ? 3 : 0;
}

/// The text with what a terminal would obey as `\x1b` or `\u202e`.
inline std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = length_of_control(text.substr(i));
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[i + k]); };
        if (length == 0) {
            shown += text[i];
        } else if (length == 3) {
            shown += fmt::format("\\u{:04x}", (byte(0) & 0x0fU) << 12U | (byte(1) & 0x3fU) << 6U | (byte(2) & 0x3fU));
        } else if (length == 2) {
            const unsigned code = (byte(0) & 0x1fU) << 6U | (byte(1) & 0x3fU);
            shown += code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
        } else {
            shown += fmt::format("\\x{:02x}", byte(0));
        }
        i += std::max<std::size_t>(length, 1);
    }
    return shown;
}

/// A text of at most about `limit` bytes: of a longer one its first two thirds of that and its end, between whole characters.
inline std::string shortened(std::string_view text, std::size_t limit) {
    if (text.size() <= limit) return std::string(text);
    const auto begins_character = [text](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0U) != 0x80U; };
    std::size_t head = limit * 2 / 3;
    std::size_t tail = text.size() - limit / 3;
    while (head > 0 && !begins_character(head)) --head;
    while (tail < text.size() && !begins_character(tail)) ++tail;
    return std::string(text.substr(0, head)) + " … " + std::string(text.substr(tail));
}

}  // namespace graincrack
