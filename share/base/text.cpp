#include "share/base/text.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

/// Smallest number of edits (insertions, removals, replacements) that turn one word into the other.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            diagonal = above;
        }
    }
    return row[b.size()];
}

/// Length in bytes of the leading character of a UTF-8 text if a terminal would interpret it, otherwise 0. These are control
/// characters, also those beyond ASCII (U+0080 to U+009F), line separators and changes of the direction of writing.
std::size_t length_of_control(std::string_view text) {
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

}  // namespace

std::pair<std::string, std::string> key_and_value(std::string_view text, std::string_view option, std::string_view form) {
    auto sides = sides_of_equals(text);
    if (sides.first.empty() || sides.first.size() == text.size()) {
        throw UsageError(fmt::format("{} {}: {} is needed", option, text, form));
    }
    return sides;
}

std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = length_of_control(text.substr(i));
        if (length == 0) {
            shown += text[i++];
            continue;
        }
        constexpr std::array<unsigned, 3> bits_of_first{0x7f, 0x1f, 0x0f};  // by the length of a character
        unsigned code = static_cast<unsigned char>(text[i]) & bits_of_first[length - 1];
        for (std::size_t k = 1; k < length; ++k) code = code << 6U | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
        shown += code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
        i += length;
    }
    return shown;
}

std::string shortened(std::string_view text, std::size_t limit) {
    if (text.size() <= limit) return std::string(text);
    const auto begins_character = [text](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0U) != 0x80U; };
    std::size_t head = limit * 2 / 3;
    std::size_t tail = text.size() - limit / 3;
    while (head > 0 && !begins_character(head)) --head;
    while (tail < text.size() && !begins_character(tail)) ++tail;
    return std::string(text.substr(0, head)) + " … " + std::string(text.substr(tail));
}

std::string text_of_stream(std::istream& stream, const std::string& name, std::size_t limit, const std::string& needed) {
    std::string text;
    for (std::array<char, 4096> bytes{}; stream && text.size() <= limit;) {
        stream.read(bytes.data(), bytes.size());
        text.append(bytes.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (text.size() > limit) {
        throw InputError(fmt::format("{}: has more than the {} MB that are read at most{}", name, limit >> 20U, needed));
    }
    if (!stream.eof()) throw InputError(fmt::format("{}: cannot be read: {}{}", name, std::strerror(errno), needed));
    return text;
}

std::string text_of_file(const std::string& file, std::size_t limit, const std::string& needed) {
    errno = 0;
    struct stat status {};
    const bool is_pipe = ::stat(file.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
    static std::map<std::pair<dev_t, ino_t>, std::string> of_pipes;
    const std::pair pipe(status.st_dev, status.st_ino);
    if (is_pipe && of_pipes.contains(pipe)) return of_pipes[pipe];
    std::ifstream stream(file, std::ios::binary);
    std::string text = text_of_stream(stream, file, limit, needed);
    if (is_pipe) of_pipes[pipe] = text;
    return text;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    std::string nearest;
    std::size_t least = (word.size() < 4 ? 1 : std::max<std::size_t>(word.size() / 3, 2)) +
                        1;  // one more than the largest distance that counts as near
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest);
}

}  // namespace graincrack
